// Notes: an edge spring weakens as its triangle is compressed, and pushes an inverted one further.
#include "lab/compression.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "lab/elastic.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "scene/fabric_words.h"
#include "study/collapse.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr int trials = 1;                     // of every start of a collapsed sheet
constexpr double base = 1;                    // [m]
constexpr double spring = 100;                // [N/m]
constexpr int samples_a_unit = 200;           // of the ratio
constexpr double first = 1.2, last = -0.2;    // of the ratio
constexpr double hair = 1e-6, inside = -0.1;  // ratios: just above the base, and well below it

// What lies at collapse is measured a hair above it.
double near(double value) {
    return std::abs(value) < 10 * hair ? 0 : value;
}

std::string verdict(double inverted) {
    constexpr double nothing = 1e-9;
    return std::abs(inverted) < nothing ? "no" : inverted > 0 ? "pushes back" : "pushes further";
}

LabFigure resistance_figure(const std::vector<CompressionCurve>& curves) {
    PanelGrid grid{1, 1, 640, 400};
    grid.right = 222;
    LabFigure figure{
        "compression",
        "Force on the apex towards its place at rest, over stretch stiffness times base, against "
        "its height over that at rest. The base is held. Left of 0 the triangle is compressed; right of it "
        "the apex is through the base, and a force below 0 pushes it further.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("A triangle pushed through its base") + plain_panel() +
            cat("set xrange [", first, ":", last,
                "]\nset xlabel 'height over rest height'\nset ylabel 'resistance / (E t base)'\n"
                "set key at screen 0.995,0.86 right top Left reverse\n"
                "set arrow 1 from 0,graph 0 to 0,graph 1 nohead lc rgb '#999999' dt (4,4)\n"
                "set label 1 'through the base' at -0.014,graph 0.66 font ',10' rotate left\n")};
    std::string plot = "plot 0 with lines lc rgb '#999999' notitle";
    // `compressed` is dashed, for it runs over `shortest`
    for (size_t i = 0; i < curves.size(); ++i) {
        std::vector<std::array<double, 2>> points;
        for (const Resistance& sample : curves[i].samples) {
            // collapse is a jump for some: no line across it
            if (sample.ratio < 0 && !points.empty() && points.back()[0] > 0) points.push_back({NAN, NAN});
            points.push_back({sample.ratio, sample.force});
        }
        figure.data += data_block(cat("c", i), points);
        plot += cat(", $c", i, " using 1:2 with lines lw 2.4 dt ",
                    curves[i].law.ends_with("compressed") ? "(6,4)" : "1", " lc rgb '", plot_colour(i),
                    "' title ", plot_quoted(curves[i].law));
    }
    figure.plot += plot + "\nunset multiplot\n";
    return figure;
}

LabTable law_table(const std::vector<CompressionCurve>& curves) {
    LabTable table{{"law", "once inverted", "greatest resistance", "at height", "left at collapse",
                    "inverted to -0.1", "work to collapse"},
                   {},
                   2};
    for (const CompressionCurve& curve : curves)
        table.rows.push_back({curve.law, verdict(curve.inverted), figure(curve.peak.force),
                              figure(near(curve.peak.ratio), 2), figure(near(curve.at_collapse)),
                              figure(curve.inverted), figure(curve.barrier)});
    return table;
}

LabTable recovery_table(const std::vector<Recovery>& recoveries) {
    LabTable table{{"altitudes", "start", "collapsed triangles", "recovered [%]"}, {}, 2};
    for (const Recovery& recovery : recoveries)
        table.rows.push_back({std::string(word_for(altitude_words, recovery.mode)),
                              std::string(name_of(recovery.start)), cat(recovery.collapsed),
                              figure(100.0 * recovery.recovered / recovery.collapsed, 3)});
    return table;
}

std::string curves_csv(const std::vector<CompressionCurve>& curves) {
    std::string text = "law,height_over_rest_height,resistance_over_stiffness_and_base\n";
    for (const CompressionCurve& curve : curves)
        for (const Resistance& sample : curve.samples)
            text +=
                cat(csv_text(curve.law), ",", csv_number(sample.ratio), ",", csv_number(sample.force), "\n");
    return text;
}

std::string claim_of(const std::vector<CompressionCurve>& curves) {
    const CompressionCurve& edges = curves.front();
    std::string back;
    for (const CompressionCurve& curve : curves)
        if (curve.inverted > 0) back += cat(back.empty() ? "" : ", ", curve.law);
    return cat("edges alone resist most at ", figure(edges.peak.ratio, 2), " of the height (",
               figure(edges.peak.force), "), nothing at collapse, and push on beyond (",
               figure(edges.inverted),
               " at -0.1); pushed back from inversion: ", back.empty() ? "by none" : back);
}

}  // namespace

std::vector<Law> compression_laws() {
    Fabric edges;
    edges.stretch = spring;
    std::vector<Law> laws{{"edges alone", edges}};
    for (const auto& word : altitude_words) {
        if (word.choice == AltitudeMode::none) continue;
        Fabric fabric = edges;
        fabric.altitude = word.choice;
        laws.push_back({"altitudes: " + std::string(word.name), fabric});
    }
    for (const auto& word : membrane_words) {
        if (word.choice == MembraneKind::none) continue;
        Fabric fabric = edges;
        fabric.membrane = word.choice;
        laws.push_back({"membrane: " + std::string(word.name), fabric});
    }
    return laws;
}

double resistance_at(const Fabric& fabric, double ratio) {
    const Model model = free_cloth(lone_triangle(base, 0.5, std::sqrt(0.75)), fabric);
    const auto forces = elastic_forces(model.cloths.front());
    const Points& rest = model.cloths.front().mesh.rest;
    Points x = rest;
    x.col(2) *= ratio;
    return forces_of(forces, x).col(2).dot(rest.col(2).normalized()) / (spring * base);
}

CompressionCurve compression_curve(const Law& law) {
    CompressionCurve curve{law.name, {}, {}, 0, 0, 0};
    const int from = static_cast<int>(std::lround(first * samples_a_unit));
    const int to = static_cast<int>(std::lround(last * samples_a_unit));
    for (int i = from; i >= to; --i) {
        const double ratio = i == 0 ? hair : static_cast<double>(i) / samples_a_unit;
        const Resistance sample{ratio, resistance_at(law.fabric, ratio)};
        curve.samples.push_back(sample);
        if (ratio > 0 && sample.force > curve.peak.force) curve.peak = sample;
        // the trapezoidal rule, between rest and collapse
        if (i >= 0 && i <= samples_a_unit)
            curve.barrier +=
                sample.force * std::sqrt(0.75) / samples_a_unit * (i == 0 || i == samples_a_unit ? 0.5 : 1);
        if (i == 0) curve.samples.push_back({-hair, resistance_at(law.fabric, -hair)});
    }
    curve.at_collapse = resistance_at(law.fabric, hair);
    curve.inverted = resistance_at(law.fabric, inside);
    return curve;
}

LabResult run_compression() {
    const std::vector<Recovery> recoveries = measure_recovery(trials);
    std::vector<CompressionCurve> curves;
    for (const Law& law : compression_laws()) curves.push_back(compression_curve(law));
    LabResult result;
    result.claim = claim_of(curves);
    result.story = {
        "An edge spring that is compressed pushes along itself. As the triangle flattens, the two springs at "
        "its apex turn parallel to the base, and of their push less and less points away from it: the "
        "resistance has a peak, is gone when the triangle is flat, and beyond that points the other way. The "
        "triangle snaps through and stays there. That is why the notes add springs along the altitudes.",
        "Altitude springs keep their direction until the triangle is flat. They do not forbid inversion but "
        "make it dear: what counts is the resistance left at collapse and the work to get there. Below the "
        "base they push further as well, like every law here, since a triangle in space that has swapped "
        "sides is a triangle turned over, with a rest shape there as good as the first. Neighbours and "
        "bending make it turn back, no law of one triangle does.",
        "So a sheet of them does recover, or not: 6 x 6 squares, thrown out of place inside a held border or "
        "squashed "
        "to a fiftieth of their width, two damped seconds later. The second table counts the triangles that "
        "were "
        "collapsed or turned over at the start and are not at the end."};
    result.figures = {resistance_figure(curves)};
    result.tables = {law_table(curves), recovery_table(recoveries)};
    result.csv = {{"compression", curves_csv(curves)}, {"recovery", recovery_csv(recoveries)}};
    return result;
}

}  // namespace drape
