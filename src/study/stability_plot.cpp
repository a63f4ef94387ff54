#include "study/stability_plot.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "study/plot_style.h"

namespace drape {

namespace {

// all in pixels
constexpr int most_columns = 5;
constexpr size_t long_title = 24;  // letters: set smaller, or it runs into the next panel's
constexpr double panel_width = 196, panel_height = 168, gap_across = 46, gap_down = 66;
constexpr double left_margin = 82, right = 20, bottom = 66, top = 84;

// Half a cell on a log axis, as a factor.
double half_of(const std::vector<double>& grid) {
    return grid.size() > 1 ? std::sqrt(grid[1] / grid[0]) : 2;
}

struct Frame {
    double half_stiffness, half_step;
    double x_low, x_high, y_low, y_high;
};

Frame frame_of(const StabilityMap& map, const StabilityFigure& figure) {
    const double x = half_of(map.stiffness), y = half_of(map.step);
    double shortest = map.step.front(), longest = map.step.back();
    for (const StabilityPanel& panel : figure.panels) {
        for (const StabilityCell* cell : panel.cells) {
            if (!(cell->step > 0)) continue;
            shortest = std::min(shortest, cell->step);
            longest = std::max(longest, cell->step);
        }
    }
    return {x, y, map.stiffness.front() / x, map.stiffness.back() * x, shortest / y, longest * y};
}

// The panel's cells of one state, as boxes; neighbours along the step are one box.
std::string boxes(const StabilityPanel& panel, const Frame& frame, Stability state) {
    std::string text;
    double from = 0, to = 0, stiffness = 0;
    const auto finish = [&] {
        if (to > 0)
            text += cat(stiffness, " ", std::sqrt(from * to), " ", stiffness / frame.half_stiffness, " ",
                        stiffness * frame.half_stiffness, " ", from, " ", to, "\n");
        to = 0;
    };
    for (const StabilityCell* cell : panel.cells) {
        if (!cell->on_grid) continue;
        const bool shown = cell->verdict.state == state;
        if (!shown || cell->stiffness != stiffness) finish();
        if (!shown) continue;
        if (to == 0) from = cell->step / frame.half_step;
        stiffness = cell->stiffness;
        to = cell->step * frame.half_step;
    }
    finish();
    return text;
}

// Stiffness and theoretical limit; "" for methods that have none.
std::string limit_line(const StabilityPanel& panel) {
    std::string text;
    double before = 0;
    for (const StabilityCell* cell : panel.cells) {
        if (!std::isfinite(cell->limit) || cell->stiffness == before) continue;
        before = cell->stiffness;
        text += cat(cell->stiffness, " ", cell->limit, "\n");
    }
    return text;
}

constexpr const char* limit_style = "with lines lc rgb '#000000' lw 2 dt (6,3)";

// Data blocks named `name`, which outlive the plot, and the command that plots them.
struct PanelText {
    std::string data, plot;
};

PanelText panel_text(const StabilityPanel& panel, const Frame& frame, const std::string& name) {
    PanelText text;
    const auto add = [&](const std::string& block, const std::string& data, const std::string& how) {
        if (data.empty()) return;
        text.data += cat("$", block, " << EOD\n", data, "EOD\n");
        text.plot += cat(text.plot.empty() ? "plot " : ", \\\n     ", "$", block, " ", how, " notitle");
    };
    for (size_t s = 0; s < stability_kinds().size(); ++s)
        add(cat(name, "_", s), boxes(panel, frame, static_cast<Stability>(s)),
            cat("with boxxyerror fs solid 1 noborder lc rgb '", stability_kinds()[s].colour, "'"));
    add(name + "_limit", limit_line(panel), limit_style);
    return text;
}

std::string legend() {
    std::string text =
        "unset logscale\nunset border\nunset tics\nunset title\nunset xlabel\nunset ylabel\n"
        "set key at graph 0.02,0.98 left top Left reverse noenhanced maxcols 1 samplen 2 spacing 1.15 font "
        "',11'\n"
        "plot [0:1][0:1] ";
    for (const StabilityKind& kind : stability_kinds())
        text += cat("NaN with boxes fs solid 1 noborder lc rgb '", kind.colour, "' title ",
                    plot_quoted(std::string(kind.name)), ", \\\n     ");
    return text + "NaN " + limit_style + " title 'theoretical limit'\n";
}

// A figure's panels and, after the last, its legend.
struct Layout {
    int slots, columns, rows;
    double width, height;  // [pixels]

    explicit Layout(size_t panels)
        : slots(static_cast<int>(panels) + 1),
          columns(std::min(slots, most_columns)),
          rows((slots + columns - 1) / columns),
          width(left_margin + right + columns * panel_width + (columns - 1) * gap_across),
          height(bottom + top + rows * panel_height + (rows - 1) * gap_down) {}

    bool is_leftmost(int slot) const { return slot % columns == 0; }
    bool is_lowest(int slot) const { return slot + columns >= slots - 1; }  // of the panels
};

// gnuplot takes tick labels with exponents to be larger than they are, and puts these beyond the picture's
// edge where they are not moved
constexpr const char *step_label = "set ylabel 'step [s]' font ',11' offset 1.2,0\n",
                     *stiffness_label = "set xlabel 'spring constant [N/m]' font ',11' offset 0,0.7\n";

std::string all_panels(const StabilityFigure& figure, const Layout& layout, const Frame& frame) {
    return cat("set multiplot title ", plot_quoted(figure.title), " noenhanced font ',16' layout ",
               layout.rows, ",", layout.columns, " margins ", left_margin / layout.width, ",",
               1 - right / layout.width, ",", bottom / layout.height, ",", 1 - top / layout.height,
               " spacing ", gap_across / layout.width, ",", gap_down / layout.height,
               "\nset logscale xy\nset border 31 lc rgb '#777777'\n",
               "set tics out nomirror textcolor rgb '#333333' font ',10'\nset format xy '10^{%L}'\n",
               "set xtics 1e-2,1e3\nset ytics 1e-6,10\nset clip two\nunset key\nset xrange [", frame.x_low,
               ":", frame.x_high, "]\nset yrange [", frame.y_low, ":", frame.y_high, "]\n");
}

std::string figure_text(const StabilityMap& map, const StabilityFigure& figure) {
    const Frame frame = frame_of(map, figure);
    const Layout layout(figure.panels.size());
    std::string data, body = all_panels(figure, layout, frame);
    for (int slot = 0; slot + 1 < layout.slots; ++slot) {
        const StabilityPanel& panel = figure.panels[static_cast<size_t>(slot)];
        const PanelText text = panel_text(panel, frame, cat("m", slot));
        data += text.data;
        body += cat("set title ", plot_quoted(panel.title), " noenhanced font ',",
                    panel.title.size() > long_title ? 9 : 12, "' offset 0,-0.4\n",
                    layout.is_leftmost(slot) ? step_label : "unset ylabel\n",
                    layout.is_lowest(slot) ? stiffness_label : "unset xlabel\n", text.plot, "\n");
    }
    body += legend() + "unset multiplot\n";
    const std::string size =
        cat(" size ", layout.width, ",", layout.height, " font 'Helvetica,12' background rgb 'white'\n");
    return cat("reset\nset encoding utf8\n", data, "set terminal svg enhanced", size, "set output '",
               figure.file, ".svg'\n", body, "reset\nset encoding utf8\nset terminal pngcairo enhanced", size,
               "set output '", figure.file, ".png'\n", body, "set output\n\n");
}

std::string cloth_title(const StabilityCloth& cloth) {
    return cloth.mesh + ", " + cloth.options;
}

}  // namespace

std::vector<StabilityFigure> figures_of(const StabilityMap& map) {
    std::vector<StabilityFigure> figures;
    StabilityFigure chosen{"auto", "Drape's own choice of method and step", {}};
    for (size_t c = 0; c < map.cloths.size(); ++c) {
        const StabilityCloth& cloth = map.cloths[c];
        StabilityFigure figure{cloth.file, "Stability: " + cloth_title(cloth), {}};
        for (const std::string_view name : map.names())
            if (StabilityPanel panel{std::string(name), map.cells_of(c, name)}; !panel.cells.empty())
                figure.panels.push_back(std::move(panel));
        chosen.panels.push_back({cloth_title(cloth), map.cells_of(c, auto_name)});
        if (figure.panels.size() > 1) figures.push_back(std::move(figure));
    }
    if (map.cloths.size() > 1) figures.push_back(std::move(chosen));
    return figures;
}

std::string stability_script(const StabilityMap& map) {
    std::string text = "# drape's stability maps; gnuplot 5 or later\n";
    for (const StabilityFigure& figure : figures_of(map)) text += figure_text(map, figure);
    return text;
}

}  // namespace drape
