#include "study/study_plot.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "study/findings.h"
#include "study/plot_labels.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr double width = 1100, height = 700;  // [pixels]
// of the area in axes, on the canvas; the legend stands to its right
constexpr double left = 0.085, right = 0.765, bottom = 0.105, top = 0.9;
constexpr double shown_error = 1e-3;  // over time: each method's cheapest rung below that [m]

struct Range {
    double low, high;
};

// The values' range with room at both ends, by factors.
Range roomy(const std::vector<double>& values, double below, double above, double least_span = 1) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {std::min(*low / below, *high * above / least_span), *high * above};
}

double share_of(const Range& range, double value) {
    return std::log(value / range.low) / std::log(range.high / range.low);
}

struct Chart {
    Range x, y;
    Pixel at(double cpu, double error) const {
        return {width * (left + (right - left) * share_of(x, cpu)),
                height * (bottom + (top - bottom) * share_of(y, error))};
    }
};

std::string heading(const Study& study, const std::string& title) {
    return cat("reset\nset encoding utf8\n", "set title ", plot_quoted(title + ": " + study.scene),
               " noenhanced font ',15'\n",
               "set border 3 lc rgb '#555555'\nset tics nomirror out textcolor rgb '#333333'\n",
               "set grid lc rgb '#e4e4e4' lw 1 lt 1\nset logscale y\nset format y '10^{%L}'\n",
               "set lmargin at screen ", left, "\nset rmargin at screen ", right, "\nset bmargin at screen ",
               bottom, "\nset tmargin at screen ", top, "\n", "set key at screen ", right + 0.012, ",", top,
               " left top Left reverse noenhanced samplen 3 spacing 1.25 font ',12'\n");
}

// Ticks of a logarithmic axis at 1, 2 and 5 where powers of ten alone would be too few.
std::string ticks(const Range& range) {
    if (range.high / range.low > 1e4) return "set format x '10^{%L}'\n";
    std::string list;
    for (int power = -9; power < 9; ++power)
        for (const double digit : {1, 2, 5})
            if (const double at = digit * std::pow(10, power); at >= range.low && at <= range.high)
                list += cat(list.empty() ? "" : ",", figure(at));
    return "set format x '%g'\nset xtics (" + list + ")\n";
}

// The same picture twice: to look at anywhere, and to put into a page.
std::string output(const std::string& name, const std::string& plot) {
    const std::string size =
        cat(" size ", width, ",", height, " font 'Helvetica,13' background rgb 'white'\n");
    return cat("set terminal svg enhanced", size, "set output '", name, ".svg'\n", plot,
               "set terminal pngcairo enhanced", size, "set output '", name, ".png'\nreplot\nset output\n\n");
}

std::string label(const Pixel& centre, const std::string& text, const std::string& colour, int size) {
    return cat("set label ", plot_quoted(text), " at screen ", centre.x() / width, ",", centre.y() / height,
               " center noenhanced front tc rgb '", colour, "' font ',", size, "'\n");
}

Pixel half_size(const std::string& text, int size) {
    return {0.31 * size * static_cast<double>(text.size()) + 2, 0.62 * size};
}

// A name above or below a line across at `error`, at its right end.
std::string level_label(const Chart& chart, PlotLabels& labels, double error, const std::string& text,
                        bool above) {
    const Pixel half = half_size(text, 11);
    const Pixel end = chart.at(chart.x.high, error);
    const Pixel centre = end + Pixel(-half.x() - 4, above ? 9 : -9);
    labels.keep_free(LabelBox{centre, half});
    labels.keep_free(chart.at(chart.x.low, error), end);
    return label(centre, text, "#666666", 11);
}

std::string level_line(double error, const std::string& dash) {
    return cat(error, " with lines lc rgb '#777777' lw 1.3 dt ", dash, " notitle");
}

Chart chart_of(const Study& study) {
    std::vector<double> cpu, error{study.bar()};
    if (study.floor() > 0) error.push_back(study.floor());
    for (const Rung& rung : study.rungs) {
        if (!rung.good()) continue;
        cpu.insert(cpu.end(), rung.cpu.begin(), rung.cpu.end());
        error.push_back(rung.errors.final_rms);
    }
    if (cpu.empty()) cpu = {1};
    return {roomy(cpu, 1.5, 2), roomy(error, 4, 3, 300)};
}

// Each rung's step beside its dot where there is room, the ends of a line first.
std::string step_labels(const Study& study, const Chart& chart, PlotLabels& labels) {
    std::string text;
    const auto add = [&](const Rung& rung) {
        const std::string says = time_text(rung.step);
        const Pixel dot = chart.at(median(rung.cpu), rung.errors.final_rms);
        if (const auto centre = labels.place(dot, half_size(says, 9)))
            text += label(*centre, says, plot_style(*rung.method).colour, 9);
    };
    for (const Method* method : study.methods()) {
        const std::vector<const Rung*> rungs = study.rungs_of(*method);
        const std::string name(method->name);
        for (const Rung* rung : rungs) {
            const Pixel dot = chart.at(median(rung->cpu), rung->errors.final_rms);
            const auto centre = labels.place(dot, half_size(name, 12));
            if (!centre) continue;
            text += label(*centre, name, plot_style(*method).colour, 12);
            break;
        }
    }
    for (const Method* method : study.methods()) {
        const std::vector<const Rung*> rungs = study.rungs_of(*method);
        add(*rungs.back());
        if (rungs.size() > 1) add(*rungs.front());
    }
    for (const Method* method : study.methods()) {
        const std::vector<const Rung*> rungs = study.rungs_of(*method);
        for (size_t i = 1; i + 1 < rungs.size(); ++i) add(*rungs[i]);
    }
    return text;
}

std::string error_against_cpu(const Study& study) {
    const Chart chart = chart_of(study);
    PlotLabels labels({width * left, height * bottom}, {width * right, height * top});
    std::string data, plot = "plot ";
    size_t block = 0;
    for (const Method* method : study.methods()) {
        const PlotStyle style = plot_style(*method);
        data += cat("$line", block, " << EOD\n");
        std::optional<Pixel> before;
        for (const Rung* rung : study.rungs_of(*method)) {
            const auto [least, most] = std::minmax_element(rung->cpu.begin(), rung->cpu.end());
            data += cat(median(rung->cpu), " ", rung->errors.final_rms, " ", *least, " ", *most, "\n");
            const Pixel dot = chart.at(median(rung->cpu), rung->errors.final_rms);
            const double from = chart.at(*least, chart.y.low).x(), to = chart.at(*most, chart.y.low).x();
            labels.keep_free(LabelBox{{(from + to) / 2, dot.y()}, {(to - from) / 2 + 5, 5}});
            if (before) labels.keep_free(*before, dot);
            before = dot;
        }
        data += "EOD\n";
        const std::string line = cat("$line", block, " using 1:2");
        plot += cat(line, ":3:4 with xerrorbars lc rgb '", style.colour, "' lw 0.8 pt 0 notitle, \\\n     ",
                    line, " with linespoints lc rgb '", style.colour, "' dt ", style.dash, " lw 2 pt ",
                    style.dot, " ps 0.9 title ", plot_quoted(std::string(method->name)), ", \\\n     ");
        ++block;
    }
    std::string levels = cat("set object rectangle from graph 0,graph 0 to graph 1,first ", study.bar(),
                             " fc rgb '#f1f1f1' fs solid noborder behind\n");
    levels += level_label(chart, labels, study.bar(),
                          "error bar of the reference: " + length_text(study.bar()), false);
    plot += level_line(study.bar(), "solid");
    if (study.floor() > 0) {
        levels +=
            level_label(chart, labels, study.floor(), "predictability floor: " + length_text(study.floor()),
                        study.floor() >= study.bar());
        plot += ", \\\n     " + level_line(study.floor(), "(7,6)");
    }
    return heading(study, "Error against run time") + "set logscale x\n" + ticks(chart.x) +
           cat("set xrange [", chart.x.low, ":", chart.x.high, "]\nset yrange [", chart.y.low, ":",
               chart.y.high, "]\nset xlabel 'CPU time of the pass [s]'\n",
               "set ylabel 'RMS error of the positions at the last frame [m]'\n") +
           levels + step_labels(study, chart, labels) + data + output("error_time", plot + "\n");
}

std::string error_over_time(const Study& study) {
    std::vector<double> errors;
    std::string data = "$bar << EOD\n", plot;
    const auto time = [&](size_t k) { return static_cast<double>(k + 1) / study.frame_rate; };
    const std::vector<ErrorNorms>& bar = study.reference.bar;
    for (size_t k = 0; k < bar.size(); ++k) {
        errors.push_back(bar[k].rms);
        data += cat(time(k), " ", bar[k].rms, "\n");
    }
    data += "EOD\n$floor << EOD\n";
    for (size_t k = 0; k < bar.size(); ++k) {
        const double floor = study.probe.floor[k];
        if (floor > 0) errors.push_back(floor);
        data += floor > 0 ? cat(time(k), " ", floor, "\n") : "";
    }
    data += "EOD\n";
    size_t block = 0;
    for (const Method* method : study.methods()) {
        const Rung& rung = *representative(study, *method, shown_error);
        const PlotStyle style = plot_style(*method);
        data += cat("$run", block, " << EOD\n");
        for (size_t k = 0; k < rung.distance.size(); ++k) {
            const double error = std::max(rung.distance[k].rms, bar[k].rms);
            errors.push_back(error);
            data += cat(time(k), " ", error, "\n");
        }
        data += "EOD\n";
        plot += cat(", \\\n     $run", block++, " with lines lc rgb '", style.colour, "' dt ", style.dash,
                    " lw 2 title ", plot_quoted(cat(method->name, ", ", time_text(rung.step))));
    }
    const Range y = roomy(errors, 4, 3, 300);
    const double end = time(bar.size() - 1);
    return heading(study, "Error over simulated time") +
           cat("set xrange [0:", end, "]\nset yrange [", y.low, ":", y.high,
               "]\nset xlabel 'simulated time [s]'\nset ylabel 'RMS error of the positions [m]'\n") +
           data +
           output("error_over_time",
                  cat("plot $bar using 1:(", y.low, "):2 with filledcurves fc rgb '#f1f1f1' notitle, \\\n",
                      "     $bar with lines lc rgb '#777777' lw 1.3 title 'reference\'\'s error bar', \\\n",
                      "     $floor with lines lc rgb '#777777' lw 1.3 dt (7,6) title 'predictability floor'",
                      plot, "\n"));
}

}  // namespace

std::string plot_script(const Study& study) {
    return "# drape's plots of one study; gnuplot 5 or later\n" + error_against_cpu(study) +
           error_over_time(study);
}

}  // namespace drape
