// Notes: what keeps one triangle from collapsing keeps a sheet of them.
#include "lab/squeeze.h"

#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "lab/compression.h"
#include "lab/equilibrium.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "mesh/pattern.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr int divisions = 8;
constexpr double step = 0.05, last = 0.1;  // of the length
constexpr double jog =
    1e-3;  // of an edge, by which inner vertices start out of place: a grid has no other way to give
constexpr double still = 1e-6;

// the start of a step: the last one's rest, pressed on, and off any symmetry
Points pressed(const Points& x, const Points& rest, double ratio, double before, double edge) {
    Points next = x;
    next.row(0) *= ratio / before;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        if (std::abs(rest(0, v)) > 0.5 - 1e-9) continue;
        // as good as random, and the same everywhere
        next(0, v) += jog * edge * std::sin(12.9898 * static_cast<double>(v + 1));
        next(2, v) += jog * edge * std::sin(78.233 * static_cast<double>(v + 1));
    }
    return next;
}

double inverted_share(const Faces& faces, const Points& x) {
    int inverted = 0;
    for (const auto& face : faces.colwise()) {
        const Vec3 a = x.col(face[0]);
        inverted += (Vec3(x.col(face[1]) - a).cross(Vec3(x.col(face[2]) - a))).y() < 0;
    }
    return inverted / static_cast<double>(faces.cols());
}

LabFigure squeeze_figure(const std::vector<SqueezeCurve>& curves) {
    PanelGrid grid{2, 1, 430, 340};
    grid.right = 232;
    LabFigure figure{
        "squeeze",
        "Left: the force on an end of a sheet that is pressed together in its plane, per width, over "
        "its stretch stiffness, against its length over that at rest. Right: the share of its "
        "triangles that are turned over.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("A sheet pressed together in its plane") + plain_panel() +
            cat("set xrange [1:", last, "]\nset xlabel 'length over rest length'\n",
                "set key at screen 0.995,0.86 right top Left reverse\n",
                "set ylabel 'force per width / (E t)'\n")};
    std::string force = "plot 0 with lines lc rgb '#999999' notitle", inverted;
    for (size_t i = 0; i < curves.size(); ++i) {
        std::vector<std::array<double, 2>> one, other;
        for (const Squeeze& sample : curves[i].samples) {
            one.push_back({sample.ratio, sample.force});
            other.push_back({sample.ratio, 100 * sample.inverted});
        }
        figure.data += data_block(cat("f", i), one) + data_block(cat("v", i), other);
        const std::string line =
            cat(" using 1:2 with linespoints pt 7 ps 0.5 lw 2 lc rgb '", plot_colour(i), "' ");
        force += cat(", $f", i, line, "title ", plot_quoted(curves[i].law));
        inverted += cat(i == 0 ? "plot $v" : ", $v", i, line, "notitle");
    }
    figure.plot +=
        force + "\nset ylabel 'turned over [%]'\nset yrange [-2:]\n" + inverted + "\nunset multiplot\n";
    return figure;
}

std::string squeeze_csv(const std::vector<SqueezeCurve>& curves) {
    std::string text = "law,length_over_rest_length,force_per_width_over_stiffness,inverted,at_rest\n";
    for (const SqueezeCurve& curve : curves)
        for (const Squeeze& sample : curve.samples)
            text += cat(csv_text(curve.law), ",", csv_number(sample.ratio), ",", csv_number(sample.force),
                        ",", csv_number(sample.inverted), ",", sample.at_rest ? 1 : 0, "\n");
    return text;
}

}  // namespace

SqueezeCurve squeeze_curve(const Law& law, int count, double to) {
    const Mesh sheet = make_pattern("alternating", {1, 1, count, count});
    Model free = free_cloth(sheet, law.fabric);
    std::vector<int> ends, moved;
    for (int v = 0; v < sheet.vertices(); ++v) {
        if (std::abs(sheet.rest(0, v)) > 0.5 - 1e-9) ends.push_back(v);
        if (sheet.rest(0, v) > 0.5 - 1e-9) moved.push_back(v);
    }
    const auto forces = elastic_forces(free.cloths.front());
    SqueezeCurve curve{law.name, {}, {}, 0};
    Points x = sheet.rest;
    const int steps = static_cast<int>(std::lround((1 - to) / step));
    for (int i = 0; i <= steps; ++i) {
        const double ratio = 1 - step * i, before = i == 0 ? 1 : ratio + step;
        Points start = pressed(x, sheet.rest, ratio, before, 1.0 / count);
        Model held = free;
        PinGroup pins;
        pins.vertices = ends;
        pins.anchors = sheet.rest(Eigen::all, ends);
        pins.anchors.row(0) *= ratio;
        start(Eigen::all, ends) = pins.anchors;
        add_pins(held, std::move(pins));
        const Equilibrium rest = come_to_rest(held, Vec3::Zero(), start, still);
        x = rest.x;
        const Points force = forces_of(forces, x);
        Squeeze sample{ratio, 0, inverted_share(sheet.faces, x), rest.found};
        for (const int v : moved) sample.force += force(0, v) / law.fabric.stretch;
        if (sample.force > curve.peak.force) curve.peak = sample;
        if (sample.inverted > 0 && curve.first_inverted == 0) curve.first_inverted = ratio;
        curve.samples.push_back(sample);
    }
    return curve;
}

LabResult run_squeeze() {
    std::vector<SqueezeCurve> curves;
    for (const Law& law : compression_laws()) curves.push_back(squeeze_curve(law, divisions, last));
    LabResult result;
    LabTable table{{"law", "greatest force / (E t)", "at length", "at half its length",
                    "first turned over at", "turned over at a tenth [%]"},
                   {},
                   1};
    result.claim = "a sheet pressed together in its plane keeps all its triangles upright down to";
    for (const SqueezeCurve& curve : curves) {
        const Squeeze& half = curve.samples[static_cast<size_t>(std::lround(0.5 / step))];
        const std::string first = curve.first_inverted > 0 ? figure(curve.first_inverted, 2) : "never";
        table.rows.push_back({curve.law, figure(curve.peak.force), figure(curve.peak.ratio, 2),
                              figure(half.force), first, figure(100 * curve.samples.back().inverted, 3)});
        result.claim += cat(curve.law == curves.front().law ? " " : ", ",
                            curve.first_inverted > 0 ? figure(curve.first_inverted + step, 2) : "a tenth",
                            " of its length (", curve.law, ")");
    }
    result.story = {
        "One triangle says what a law is like; a sheet says what it does. 8 x 8 squares are held at two ends "
        "and "
        "pressed together without leaving their plane, with their other two sides free. Inner vertices start "
        "a "
        "thousandth of an edge out of place, so that a symmetric grid can give way as a real one would.",
        "Where the force falls the sheet is no longer pressed evenly: some of its rows collapse and let the "
        "others go, and what was one law for all triangles becomes a few flat ones and many that rest."};
    result.figures = {squeeze_figure(curves)};
    result.tables = {table};
    result.csv = {{"squeeze", squeeze_csv(curves)}};
    return result;
}

}  // namespace drape
