// Cloth against closed forms: cantilever, curtain, strip, slope.
#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/numbers.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "lab/validation.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr std::array loads{1.0, 10.0, 100.0};
constexpr std::array fineness{16, 32, 64};  // edges along the strip
constexpr std::array<std::string_view, 5> meshes{"one_way", "equilateral", "adaptive", "pseudo_random",
                                                 "alternating"};
struct Kind {
    BendingKind kind;
    std::string name;
};
const std::array kinds{Kind{BendingKind::plate, "plate"}, Kind{BendingKind::hinge, "hinge"}};

struct Strip {
    size_t mesh, kind, load;
    int divisions;
    HangingTip tip;
    double expected;  // the tip's slope
    double off() const { return tip.slope() / expected - 1; }
};

std::vector<Strip> measure_strips() {
    std::vector<Strip> strips;
    for (size_t load = 0; load < loads.size(); ++load) {
        const double expected = heavy_cantilever(loads[load]).slope();
        for (size_t kind = 0; kind < kinds.size(); ++kind)
            for (size_t mesh = 0; mesh < meshes.size(); ++mesh)
                for (const int divisions : fineness)
                    strips.push_back({mesh, kind, load, divisions,
                                      loaded_tip(meshes[mesh], kinds[kind].kind, loads[load], divisions),
                                      expected});
    }
    return strips;
}

std::vector<Check> checks_of(const std::vector<Strip>& strips) {
    std::vector<Check> checks;
    for (size_t i = 0; i < strips.size(); ++i) {
        const Strip& fine = strips[i];
        if (fine.divisions != fineness.back()) continue;
        checks.push_back({cat("cantilever, G = ", loads[fine.load], ": drop / reach"),
                          cat(kinds[fine.kind].name, ", ", meshes[fine.mesh]), fine.expected,
                          fine.tip.slope(), 0.01, cat(fine.divisions, " edges")});
    }
    for (const Check& check : check_curtain(40)) checks.push_back(check);
    Fabric fabric;
    fabric.density = 0.2;
    fabric.stretch = 1e4;
    checks.push_back(check_strip("springs along edges", fabric, 60));
    fabric.altitude = AltitudeMode::blend;
    checks.push_back(check_strip("edges and blend", fabric, 60));
    fabric.altitude = AltitudeMode::none;
    fabric.membrane_poisson = 0.3;
    for (const auto& [name, kind] :
         {std::pair{"stvk", MembraneKind::stvk}, {"neo_hookean", MembraneKind::neo_hookean}}) {
        fabric.membrane = kind;
        checks.push_back(check_strip(cat("membrane ", name), fabric, 60));
    }
    for (const Check& check : check_slope()) checks.push_back(check);
    return checks;
}

LabFigure shape_figure(const std::vector<Strip>& strips) {
    PanelGrid grid{2, 1, 360, 330};
    grid.right = 30, grid.top = 84;
    LabFigure figure{
        "validation",
        "Strips clamped at the left, under loads G of 1, 10 and 100, the finest mesh of each kind: the "
        "elastica (black) and the vertices near the middle line. Left by plates, right by hinges.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("A heavy cantilever against the elastica") + plain_panel() +
            "set xrange [0:1.02]\nset yrange [-1.0:0.03]\nset xlabel 'along / L'\nset ylabel 'down / L'\n"};
    for (size_t load = 0; load < loads.size(); ++load) {
        std::vector<std::array<double, 2>> points = heavy_cantilever(loads[load]).places;
        for (auto& [x, y] : points) y = -y;
        figure.data += data_block(cat("e", load), points);
    }
    for (size_t kind = 0; kind < kinds.size(); ++kind) {
        figure.plot += cat("set title '", kinds[kind].name, "' font ',13' offset 0,-0.4\n",
                           kind > 0 ? "set ylabel ''\nunset key\n" : "set key bottom right Left reverse\n");
        std::string plot;
        for (size_t mesh = 0; mesh < meshes.size(); ++mesh) {
            const std::string name = cat("k", kind, "_", mesh);
            std::vector<std::array<double, 2>> points;
            for (const Strip& strip : strips) {
                if (strip.kind != kind || strip.mesh != mesh || strip.divisions != fineness.back()) continue;
                for (size_t i = 0; i < strip.tip.places.size();
                     i += std::max<size_t>(1, strip.tip.places.size() / 24))
                    points.push_back(
                        {strip.tip.places[i][0] / loaded_length, -strip.tip.places[i][1] / loaded_length});
            }
            figure.data += data_block(name, points);
            plot += cat(plot.empty() ? "plot $" : ", $", name, " using 1:2 with points pt 7 ps 0.45 lc rgb '",
                        plot_colour(mesh), "' title ", plot_quoted(std::string(meshes[mesh])));
        }
        for (size_t load = 0; load < loads.size(); ++load)
            plot += cat(", $e", load, " using 1:2 with lines lw 1 lc rgb '#000000' notitle");
        figure.plot += plot + "\n";
    }
    figure.plot += "unset multiplot\n";
    return figure;
}

LabFigure refinement_figure(const std::vector<Strip>& strips) {
    PanelGrid grid{2, 1, 360, 300};
    grid.right = 30, grid.top = 84;
    LabFigure figure{
        "validation_refinement",
        "How far the tip's slope is off the elastica's at G = 10, against the edges along the strip. Plates "
        "converge on every mesh; hinges go to a factor that the mesh sets.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("What refinement mends, and what it does not") + plain_panel() +
            "set logscale x\nset xtics (16,32,64)\nset xrange [14:74]\n"
            "set xlabel 'edges along the strip'\nset ylabel 'off [%]'\n"};
    for (size_t kind = 0; kind < kinds.size(); ++kind) {
        figure.plot += cat("set title '", kinds[kind].name, "' font ',13' offset 0,-0.4\n",
                           kind > 0 ? "set ylabel ''\nunset key\n" : "set key top right\n");
        std::string plot = "plot 0 with lines lc rgb '#999999' dt (4,4) notitle";
        for (size_t mesh = 0; mesh < meshes.size(); ++mesh) {
            const std::string name = cat("k", kind, "_", mesh);
            std::vector<std::array<double, 2>> points;
            for (const Strip& strip : strips)
                if (strip.kind == kind && strip.mesh == mesh && loads[strip.load] == 10)
                    points.push_back({double(strip.divisions), 100 * strip.off()});
            figure.data += data_block(name, points);
            plot += cat(", $", name, " using 1:2 with linespoints pt 7 ps 0.7 lw 2 lc rgb '",
                        plot_colour(mesh), "' title ", plot_quoted(std::string(meshes[mesh])));
        }
        figure.plot += plot + "\n";
    }
    figure.plot += "unset multiplot\n";
    return figure;
}

std::string share_text(double share) {
    return figure(100 * share, 2);
}

LabTable check_table(const std::vector<Check>& checks) {
    LabTable table{{"problem", "on", "", "reference", "measured", "off [%]", "tolerance [%]", "mesh"}, {}, 3};
    for (const Check& check : checks) {
        const bool relative = check.reference != 0;
        table.rows.push_back(
            {check.problem, check.on, check.passes() ? "PASS" : "FAIL", figure(check.reference, 5),
             figure(check.measured, 5), relative ? share_text(check.off()) : "-",
             relative ? share_text(check.tolerance) : cat(check.tolerance, " mm"), check.fineness});
    }
    return table;
}

// "plate, alternating (up to 52 %)", ...: what fails on each mesh with each law, the worst.
std::string failures(const std::vector<Check>& checks) {
    std::vector<Check> worst;
    for (const Check& check : checks) {
        if (check.passes()) continue;
        const auto same = std::find_if(worst.begin(), worst.end(),
                                       [&](const Check& other) { return other.on == check.on; });
        if (same == worst.end())
            worst.push_back(check);
        else if (std::abs(check.off()) > std::abs(same->off()))
            *same = check;
    }
    std::string text;
    for (const Check& check : worst)
        text += cat(text.empty() ? "" : "; ", check.on, " (up to ", share_text(std::abs(check.off())), " %)");
    return text.empty() ? "none" : text;
}

std::string checks_csv(const std::vector<Check>& checks) {
    std::string text = "problem,on,passes,reference,measured,tolerance,mesh\n";
    for (const Check& check : checks)
        text += cat(csv_text(check.problem), ",", csv_text(check.on), ",", check.passes() ? "yes" : "no", ",",
                    csv_number(check.reference), ",", csv_number(check.measured), ",",
                    csv_number(check.tolerance), ",", csv_text(check.fineness), "\n");
    return text;
}

std::string strips_csv(const std::vector<Strip>& strips) {
    std::string text = "bending,mesh,load,edges_along,slope,elastica\n";
    for (const Strip& strip : strips)
        text +=
            cat(kinds[strip.kind].name, ",", meshes[strip.mesh], ",", loads[strip.load], ",", strip.divisions,
                ",", csv_number(strip.tip.slope()), ",", csv_number(strip.expected), "\n");
    return text;
}

}  // namespace

LabResult run_validation() {
    const std::vector<Strip> strips = measure_strips();
    const std::vector<Check> checks = checks_of(strips);
    const long passed =
        std::count_if(checks.begin(), checks.end(), [](const Check& check) { return check.passes(); });
    LabResult result;
    result.claim =
        cat(passed, " of ", checks.size(), " checks against closed forms pass; not: ", failures(checks));
    result.story = {
        "Problems whose answer is known: a strip clamped at one end bends like Euler's elastica, a curtain "
        "swings with "
        "the zeros of Bessel's function, a strip stretches by its own weight, a sheet on a slope holds or "
        "slides as "
        "Coulomb's law has it. Each is measured on the engine's own forces, and what is farther off than its "
        "tolerance "
        "says FAIL.",
        "A clamp is a row of triangles that are held. The edge at its far side bends too, half as far as one "
        "inside, so that the clamp ends in the middle of the row: lengths count from there. With plates the "
        "strip then hangs as the elastica on every mesh, and what is off falls by four where edges are half "
        "as long.",
        "Hinges have the rigidity asked for inside equilateral meshes alone, and edges of the border have "
        "none, which a narrow strip feels.",
        "A strip of springs stretches along its length by what its mesh has in that direction (see "
        "anisotropy); finite "
        "elements by the closed form's figure."};
    result.figures = {shape_figure(strips), refinement_figure(strips)};
    result.tables = {check_table(checks)};
    result.csv = {{"validation", checks_csv(checks)}, {"validation_cantilever", strips_csv(strips)}};
    return result;
}

}  // namespace drape
