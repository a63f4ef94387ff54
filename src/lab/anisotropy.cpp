// Notes: regular meshes make cloth that is stiffer along their lines; irregular ones do not.
#include "lab/anisotropy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "mesh/pattern.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr double stretch = 100;  // [N/m], or [N] per strain
// of the sheets whose curves are drawn: 60 rows of equilateral triangles fit
constexpr int drawn_divisions = 52;
constexpr std::array fineness{8, 12, 16, 24, 32, 48, 64};
constexpr std::uint64_t seeds = 3;  // of irregular sheets, for each fineness
constexpr double good = 1.1;        // most over least that counts as alike in every direction

// Most over least modulus in stretch of irregular sheets of one fineness.
struct FinenessRow {
    std::string law;
    int divisions;
    double least = INFINITY, most = 0, mean = 0;
};

std::vector<FinenessRow> measure_fineness(const std::vector<Law>& all) {
    std::vector<FinenessRow> rows;
    for (const Law& law : all) {
        if (law.fabric.membrane != MembraneKind::none) continue;
        for (const int count : fineness) {
            FinenessRow row{law.name, count};
            for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
                const double ratio = pattern_stiffness("pseudo_random", law, count, seed).stretch.ratio();
                row.least = std::min(row.least, ratio);
                row.most = std::max(row.most, ratio);
                row.mean += ratio / static_cast<double>(seeds);
            }
            rows.push_back(row);
        }
    }
    return rows;
}

// "1.026"
std::string ratio_text(double ratio) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(3) << ratio;
    return text.str();
}

// The polar curve over its own mean, both halves: a pull has no sign.
std::vector<std::array<double, 2>> polar(const DirectionCurve& curve) {
    std::vector<std::array<double, 2>> points;
    for (size_t i = 0; i <= 2 * curve.value.size(); ++i) {
        const size_t at = i % curve.value.size();
        const double angle = (curve.angle_deg[at] + (i / curve.value.size() % 2 == 1 ? 180 : 0));
        const double radius = curve.value[at] / curve.mean, rad = angle * std::numbers::pi / 180;
        points.push_back({radius * std::cos(rad), radius * std::sin(rad)});
    }
    return points;
}

// No axes, one reach for all.
std::string polar_panel(double reach) {
    return cat("unset border\nunset tics\nunset key\nunset grid\nset parametric\nset trange [0:2*pi]\n",
               "set samples 200\nset xrange [", -reach, ":", reach, "]\nset yrange [", -reach, ":", reach,
               "]\n");
}

std::string legend(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < names.size(); ++i)
        text += cat("set label ", i + 1, " ", plot_quoted("\u25cf " + names[i]), " at screen ",
                    (static_cast<double>(i) + 0.5) / static_cast<double>(names.size()),
                    ",screen 0.035 center noenhanced font ',14' textcolor rgb '", plot_colour(i), "'\n");
    return text;
}

LabFigure polar_figure(const std::vector<PatternStiffness>& all, const std::vector<Law>& kinds) {
    const std::vector<std::string> patterns = even_patterns();
    PanelGrid grid{static_cast<int>(kinds.size()), 2, 270, 270};
    grid.left = 46, grid.right = 20, grid.across = 16, grid.down = 44, grid.top = 92, grid.bottom = 60;
    double reach = 1.2;
    LabFigure figure{"anisotropy",
                     "Modulus against direction, each over its own mean; the dashed circle is cloth that is "
                     "alike in every direction. Above in stretch, below in shear.",
                     grid.width(),
                     grid.height(),
                     "",
                     legend(patterns) + grid.begin("Stiffness by direction")};
    for (const PatternStiffness& one : all)
        reach = std::max(
            {reach, 1.08 * one.stretch.most / one.stretch.mean, 1.08 * one.shear.most / one.shear.mean});
    figure.plot += polar_panel(reach);
    for (const bool shear : {false, true}) {
        for (size_t k = 0; k < kinds.size(); ++k) {
            figure.plot += cat("set title ", shear ? "''" : plot_quoted(kinds[k].name),
                               " noenhanced font ',13' offset 0,0.2\n", "set ylabel ",
                               k > 0   ? "''"
                               : shear ? "'shear' font ',13'"
                                       : "'stretch' font ',13'",
                               "\n");
            std::string plot =
                "plot 0.5*cos(t),0.5*sin(t) with lines lc rgb '#e2e2e2' notitle, "
                "1.5*cos(t),1.5*sin(t) with lines lc rgb '#e2e2e2' notitle";
            for (size_t p = 0; p < patterns.size(); ++p) {
                const auto one = std::find_if(all.begin(), all.end(), [&](const PatternStiffness& row) {
                    return row.pattern == patterns[p] && row.law == kinds[k].name;
                });
                const std::string name = cat(shear ? "g" : "e", k, "_", p);
                figure.data += data_block(name, polar(shear ? one->shear : one->stretch));
                plot +=
                    cat(", $", name, " using 1:2 with lines lw 2.2 lc rgb '", plot_colour(p), "' notitle");
            }
            figure.plot +=
                plot + ", cos(t),sin(t) with lines lc rgb '#000000' lw 1.5 dt (5,5) notitle\nunset label\n";
        }
    }
    figure.plot += "unset multiplot\n";
    return figure;
}

LabFigure fineness_figure(const std::vector<FinenessRow>& rows) {
    const PanelGrid grid{1, 1, 620, 330};
    LabFigure figure{"anisotropy_fineness",
                     cat("Irregular sheets: how far from a circle, most over least modulus in stretch, "
                         "against how fine they are; mean and range of ",
                         seeds, " sheets. Dashed: ", good, "."),
                     grid.width(),
                     grid.height(),
                     "",
                     grid.begin("Irregular sheets even out as they grow finer") + plain_panel() +
                         "set logscale x\nset xtics (8,12,16,24,32,48,64)\nset xrange [7.4:70]\n"
                         "set xlabel 'quads along a side'\nset ylabel 'most over least modulus'\n"};
    std::string plot = cat("plot ", good, " with lines lc rgb '#000000' dt (6,4) notitle");
    std::string law;
    size_t colour = 0;
    for (size_t i = 0; i < rows.size();) {
        const std::string name = cat("f", colour);
        std::string data = cat("$", name, " << EOD\n");
        for (law = rows[i].law; i < rows.size() && rows[i].law == law; ++i)
            data += cat(rows[i].divisions * (0.98 + 0.02 * static_cast<double>(colour)), " ", rows[i].mean,
                        " ", rows[i].least, " ", rows[i].most, "\n");
        figure.data += data + "EOD\n";
        plot += cat(", $", name, " using 1:2 with lines lw 2 lc rgb '", plot_colour(colour), "' title ",
                    plot_quoted(law), ", $", name, " with yerrorbars pt 7 ps 0.6 lw 1.4 lc rgb '",
                    plot_colour(colour), "' notitle");
        ++colour;
    }
    figure.plot += plot + "\nunset multiplot\n";
    return figure;
}

LabTable pattern_table(const std::vector<PatternStiffness>& all) {
    LabTable table{{"law", "pattern", "stretch, most / least", "shear, most / least",
                    "mean stretch modulus [N/m]", "mean shear modulus [N/m]"},
                   {},
                   2};
    for (const PatternStiffness& one : all)
        table.rows.push_back({one.law, one.pattern, ratio_text(one.stretch.ratio()),
                              ratio_text(one.shear.ratio()), figure(one.stretch.mean, 4),
                              figure(one.shear.mean, 4)});
    return table;
}

LabTable fineness_table(const std::vector<FinenessRow>& rows) {
    LabTable table{
        {"pseudo_random", "quads along a side", "stretch, most / least: mean", "least", "most"}, {}, 1};
    for (const FinenessRow& row : rows)
        table.rows.push_back({row.law, figure(row.divisions, 2), ratio_text(row.mean), ratio_text(row.least),
                              ratio_text(row.most)});
    return table;
}

std::string curves_csv(const std::vector<PatternStiffness>& all) {
    std::string text = "law,pattern,direction_deg,stretch_modulus_n_per_m,shear_modulus_n_per_m\n";
    for (const PatternStiffness& one : all)
        for (size_t i = 0; i < one.stretch.value.size(); ++i)
            text += cat(csv_text(one.law), ",", one.pattern, ",", one.stretch.angle_deg[i], ",",
                        csv_number(one.stretch.value[i]), ",", csv_number(one.shear.value[i]), "\n");
    return text;
}

std::string fineness_csv(const std::vector<FinenessRow>& rows) {
    std::string text = "law,quads_along_a_side,sheets,mean_ratio,least_ratio,most_ratio\n";
    for (const FinenessRow& row : rows)
        text += cat(csv_text(row.law), ",", row.divisions, ",", seeds, ",", csv_number(row.mean), ",",
                    csv_number(row.least), ",", csv_number(row.most), "\n");
    return text;
}

// The notes' own springs, the finest irregular sheets of them, and the worst finite elements.
std::string claim_of(const std::vector<PatternStiffness>& all, const std::vector<FinenessRow>& rows,
                     const std::vector<Law>& kinds) {
    std::string text = "most over least modulus in stretch:";
    double worst_element = 1;
    for (const PatternStiffness& one : all) {
        if (one.law == kinds.front().name && one.pattern != "pseudo_random")
            text += cat(" ", one.pattern, " ", ratio_text(one.stretch.ratio()), ",");
        if (one.law == kinds.back().name) worst_element = std::max(worst_element, one.stretch.ratio());
    }
    for (const FinenessRow& row : rows)
        if (row.law == kinds.front().name && row.divisions == fineness.back())
            text +=
                cat(" pseudo_random ", ratio_text(row.mean), " (", row.divisions, " x ", row.divisions, ")");
    return cat(text, "; finite elements ", ratio_text(worst_element), " on every pattern");
}

}  // namespace

std::vector<Law> stretch_laws() {
    Fabric notes;
    notes.stretch = stretch;
    notes.stretch_model = StretchModel::force_per_strain;
    Fabric spread = notes;
    spread.stretch_model = StretchModel::membrane;
    Fabric blend = spread;
    blend.altitude = AltitudeMode::blend;
    Fabric elements = spread;
    elements.membrane = MembraneKind::stvk;
    return {{"edges, one k for all", notes},
            {"edges, spread by area", spread},
            {"edges and blend", blend},
            {"finite elements", elements}};
}

PatternStiffness pattern_stiffness(std::string_view pattern, const Law& law, int count, std::uint64_t seed) {
    const Elasticity elasticity =
        measure_elasticity(make_pattern(pattern, {1, 1, count, count, seed}), law.fabric);
    return {std::string(pattern), law.name, stretch_curve(elasticity), shear_curve(elasticity)};
}

LabResult run_anisotropy() {
    const std::vector<Law> kinds = stretch_laws();
    std::vector<PatternStiffness> all;
    for (const Law& law : kinds)
        for (const std::string& pattern : even_patterns())
            all.push_back(pattern_stiffness(pattern, law, drawn_divisions, 1));
    const std::vector<FinenessRow> rows = measure_fineness(kinds);
    LabResult result;
    result.claim = claim_of(all, rows, kinds);
    result.story = {
        "The notes build cloth from springs along the edges of a triangulation and warn that regular ones "
        "are "
        "stiffer along their lines. Here a virtual test measures by how much: the border of a square sheet "
        "is "
        "strained, the vertices inside come to rest, and the energy in the middle of the sheet tells its "
        "elastic matrix, from which follow the moduli of a pull and of a shear in every direction.",
        "drape inspect prints a modulus by direction too. That one moves every vertex with the strain, which "
        "is exact on regular patterns and too stiff on irregular ones, and it knows no shear; so it is not "
        "used here.",
        "Springs in three directions 60 degrees apart are alike in every direction, which is why equilateral "
        "triangles draw a circle. Irregular sheets come near one, the nearer the finer they are, since many "
        "triangles average out. Finite elements are the referee: whatever the mesh, a circle."};
    result.figures = {polar_figure(all, kinds), fineness_figure(rows)};
    result.tables = {pattern_table(all), fineness_table(rows)};
    result.csv = {{"anisotropy", curves_csv(all)}, {"anisotropy_fineness", fineness_csv(rows)}};
    return result;
}

}  // namespace drape
