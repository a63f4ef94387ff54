// Notes: altitude springs of one triangle fight each other; take the shortest, or those compressed.
#include "lab/conflict.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "lab/cusick.h"
#include "lab/elastic.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "mesh/pattern.h"
#include "scene/fabric_words.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr int divisions = 32;                     // of the patterns
constexpr std::array edges{0.02, 0.0155, 0.012};  // of the discs' triangles [m]

struct ModeRow {
    std::string mode;
    double edge;
    ModeDrape drape;
};

std::vector<ModeRow> drape_modes() {
    std::vector<ModeRow> rows;
    for (const auto& word : altitude_words)
        for (const double edge : edges)
            rows.push_back({std::string(word.name), edge, drape_with(word.choice, edge)});
    return rows;
}

LabFigure drape_figure(const std::vector<ModeRow>& rows) {
    PanelGrid grid{1, 1, 560, 320};
    LabFigure figure{
        "conflict",
        "Drape coefficient of silk against how coarse the disc's triangles are, by altitude mode. What "
        "makes cloth rigid where it is coarse lies high on the right.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("Altitude springs and drape") + plain_panel() +
            "set logscale x\nset xtics (12,15.5,20)\nset xrange [11.3:21.3]\nset xlabel 'edge [mm]'\n"
            "set ylabel 'drape coefficient [%]'\nset key top left\n"};
    std::string plot;
    for (size_t i = 0; i < rows.size(); i += edges.size()) {
        std::vector<std::array<double, 2>> points;
        for (size_t k = i; k < i + edges.size(); ++k)
            points.push_back({1e3 * rows[k].edge, 100 * rows[k].drape.coefficient});
        const size_t colour = i / edges.size();
        figure.data += data_block(cat("m", colour), points);
        plot +=
            cat(plot.empty() ? "plot $m" : ", $m", colour, " using 1:2 with linespoints pt 7 lw 2 lc rgb '",
                plot_colour(colour), "' title ", plot_quoted(rows[i].mode));
    }
    figure.plot += plot + "\nunset multiplot\n";
    return figure;
}

LabTable feet_table() {
    LabTable table{
        {"pattern", "feet outside their edge [%]", "greatest share of the force at one end"}, {}, 1};
    for (const std::string& pattern : even_patterns()) {
        const Feet feet = feet_of(make_pattern(pattern, {1, 1, divisions, divisions}));
        table.rows.push_back({pattern, figure(100 * feet.outside, 3), figure(feet.most_lever, 3)});
    }
    return table;
}

// Steps over those of springs along edges alone, and the drape coefficient, coarse and fine.
LabTable mode_table(const std::vector<ModeRow>& rows) {
    LabTable table{
        {"altitudes", "drape, edges of 20 mm [%]", "12 mm [%]", "steps over those of none"}, {}, 1};
    const double plain = rows[edges.size() - 1].drape.omega;
    for (size_t i = 0; i < rows.size(); i += edges.size()) {
        const ModeRow &coarse = rows[i], &fine = rows[i + edges.size() - 1];
        table.rows.push_back({coarse.mode, figure(100 * coarse.drape.coefficient, 3),
                              figure(100 * fine.drape.coefficient, 3), figure(fine.drape.omega / plain, 3)});
    }
    return table;
}

std::string modes_csv(const std::vector<ModeRow>& rows) {
    std::string text = "altitudes,edge_m,drape_coefficient,fastest_mode_per_s\n";
    for (const ModeRow& row : rows)
        text += cat(row.mode, ",", csv_number(row.edge), ",", csv_number(row.drape.coefficient), ",",
                    csv_number(row.drape.omega), "\n");
    return text;
}

}  // namespace

Feet feet_of(const Mesh& mesh) {
    Feet feet;
    int outside = 0;
    for (int f = 0; f < mesh.triangles(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = mesh.rest.col(mesh.faces((k + 1) % 3, f)),
                       b = mesh.rest.col(mesh.faces((k + 2) % 3, f));
            const Vec3 c = mesh.rest.col(mesh.faces(k, f));
            const double foot = (c - a).dot(b - a) / (b - a).squaredNorm();
            // a right angle's foot stands on the edge's end
            outside += foot < -1e-9 || foot > 1 + 1e-9;
            feet.most_lever = std::max({feet.most_lever, foot, 1 - foot});
        }
    }
    feet.outside = outside / (3.0 * mesh.triangles());
    return feet;
}

ModeDrape drape_with(AltitudeMode mode, double edge) {
    Fabric fabric = fabric_preset("silk");
    fabric.altitude = mode;
    const CusickDrape drape = drape_disc(fabric, edge);
    return {drape.coefficient, drape.omega};
}

LabResult run_conflict() {
    const std::vector<ModeRow> rows = drape_modes();
    LabResult result;
    const auto at = [&](std::string_view mode, double edge) {
        return *std::find_if(rows.begin(), rows.end(),
                             [&](const ModeRow& row) { return row.mode == mode && row.edge == edge; });
    };
    const double plain = at("none", edges.back()).drape.omega;
    result.claim = cat("drape coefficient of silk at edges of 20 and 12 mm:");
    for (const auto& word : altitude_words) {
        const std::string name(word.name);
        result.claim += cat(result.claim.ends_with(':') ? " " : ", ", name, " ",
                            figure(100 * at(name, edges.front()).drape.coefficient, 3), " and ",
                            figure(100 * at(name, edges.back()).drape.coefficient, 3), " % (",
                            figure(at(name, edges.back()).drape.omega / plain, 3), " times the steps)");
    }
    result.story = {
        "Where a triangle is obtuse an altitude's foot lies outside its edge: one end of the edge is pulled "
        "with more "
        "than the altitude's force, the other pushed. Regular patterns have no such triangle; irregular ones "
        "do.",
        "All three altitudes at once also stiffen a sheet that should fold. A disc of silk in Cusick's test "
        "shows it: "
        "the same cloth, by every mode, on coarse and on fine triangles. The cost is that of steps, which "
        "the fastest "
        "mode at rest asks for, over those of springs along edges alone."};
    result.figures = {drape_figure(rows)};
    result.tables = {mode_table(rows), feet_table()};
    result.csv = {{"conflict", modes_csv(rows)}};
    return result;
}

}  // namespace drape
