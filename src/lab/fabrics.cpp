// Every fabric preset, measured as a textile laboratory would.
#include "lab/fabrics.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "lab/textile.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr double disc_edge = 0.008;  // of the draped discs' triangles [m]

std::string percent(double share) {
    return figure(100 * share, 3);
}

// "inside", or by how much it misses.
std::string verdict(double coefficient, const DrapeBand& band) {
    if (coefficient < band.least) return cat(percent(band.least - coefficient), " below");
    if (coefficient > band.most) return cat(percent(coefficient - band.most), " above");
    return "inside";
}

std::string hex(double share) {
    constexpr std::string_view digits = "0123456789abcdef";
    const int level = std::clamp(static_cast<int>(std::lround(255 * share)), 0, 255);
    return {digits[static_cast<size_t>(level / 16)], digits[static_cast<size_t>(level % 16)]};
}

// Lit from the upper left.
std::string shade(const Vec3& normal) {
    const double lit = 0.25 + 0.7 * std::max(0.0, normal.dot(Vec3(-0.45, 0.8, -0.4).normalized()));
    return cat("#", hex(0.62 * lit), hex(0.78 * lit), hex(lit));
}

constexpr double overlap = 1.08;  // of triangles, so that no seams show

// Its triangles that face up, the lowest first, in millimetres.
std::string disc_objects(const CusickDrape& disc) {
    struct Facet {
        double height;
        std::string text;
    };
    std::vector<Facet> facets;
    for (int f = 0; f < disc.mesh.triangles(); ++f) {
        const auto corner = [&](int k) { return Vec3(disc.x.col(disc.mesh.faces(k, f))); };
        const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        const Vec3 centre = (corner(0) + corner(1) + corner(2)) / 3;
        if (normal.y() <= 0 || std::hypot(centre.x(), centre.z()) < support_radius) continue;
        std::string text = "set object polygon from ";
        for (int k = 0; k < 4; ++k) {
            const Vec3 at = centre + overlap * (corner(k % 3) - centre);
            text += cat(k > 0 ? " to " : "", 0.1 * std::round(1e4 * at.x()), ",",
                        -0.1 * std::round(1e4 * at.z()));
        }
        facets.push_back({centre.y(), text + cat(" fc rgb '", shade(normal), "' fs solid noborder\n")});
    }
    std::stable_sort(facets.begin(), facets.end(),
                     [](const Facet& a, const Facet& b) { return a.height < b.height; });
    std::string all = cat("set object circle at 0,0 size ", 1e3 * support_radius, " fc rgb '",
                          shade(Vec3::UnitY()), "' fs solid noborder\n");
    for (const Facet& facet : facets) all += facet.text;
    return all;
}

LabFigure disc_figure(const std::vector<FabricMeasures>& all) {
    const int columns = std::min<int>(3, static_cast<int>(all.size()));
    PanelGrid grid{columns, (static_cast<int>(all.size()) + columns - 1) / columns, 250, 250};
    grid.left = grid.right = 20, grid.across = 16, grid.down = 34, grid.top = 84, grid.bottom = 20;
    LabFigure figure{
        "fabric",
        "Discs of 30 cm over a support of 18 cm, from above. Dashed: the flat disc, and the support.",
        grid.width(),
        grid.height(),
        "",
        grid.begin("Cusick's drape test") +
            "unset border\nunset tics\nunset key\nset parametric\nset trange [0:2*pi]\nset samples 120\n"
            "set xrange [-155:155]\nset yrange [-155:155]\n"};
    for (const FabricMeasures& one : all)
        figure.plot +=
            cat("set title ", plot_quoted(cat(one.name, ", ", percent(one.drape.coefficient), " %")),
                " noenhanced font ',13' offset 0,-0.5\n", disc_objects(one.drape),
                "plot 150*cos(t),150*sin(t) with lines lc rgb '#999999' dt (3,3), 90*cos(t),90*sin(t) with "
                "lines lc rgb '#ffffff' dt (3,3)\nunset object\n");
    figure.plot += "unset multiplot\n";
    return figure;
}

LabFigure bending_figure(const std::vector<FabricMeasures>& all) {
    PanelGrid grid{1, 1, 620, 340};
    LabFigure figure{"fabric_bending",
                     "Drape coefficient against bending length. Bars: bands usually quoted.",
                     grid.width(),
                     grid.height(),
                     "",
                     grid.begin("What bends easily drapes") + plain_panel() +
                         "set xlabel 'bending length (B / w)^{1/3} [mm]'\n"
                         "set logscale x\nset xtics (5,7,10,14,20,28,40,80,160)\n"
                         "set ylabel 'drape coefficient [%]'\nset yrange [0:105]\nset xrange [5:230]\n"};
    std::string own = "$own << EOD\n", bars = "$bars << EOD\n";
    for (const FabricMeasures& one : all) {
        const double weight = one.fabric.density * standard_gravity;
        const double c = 1e3 * std::cbrt(one.fabric.bending / weight);
        own += cat(drape::figure(c, 5), " ", 100 * one.drape.coefficient, " \"", one.name, "\"\n");
        if (const auto band = drape_band(one.name))
            bars +=
                cat(drape::figure(c, 5), " ", 100 * band->least, " ", 100 * (band->most - band->least), "\n");
    }
    figure.data = own + "EOD\n" + bars + "EOD\n";
    std::string plot;
    const auto add = [&](const std::string& block, const std::string& text) {
        if (block.find('\n') != block.rfind('\n')) plot += (plot.empty() ? "plot " : ", ") + text;
    };
    add(bars, cat("$bars using 1:2:(0):3 with vectors nohead lw 6 lc rgb '#d5d5d5' notitle"));
    add(own, cat("$own using 1:2 with points pt 7 ps 1.2 lc rgb '", plot_colour(0),
                 "' notitle, $own using 1:2:3 with labels left offset 1,-0.4 font ',11' noenhanced notitle"));
    figure.plot += plot + "\nunset multiplot\n";
    return figure;
}

LabTable drape_table(const std::vector<FabricMeasures>& all) {
    LabTable table{{"fabric", "drape coefficient [%]", "band [%]", "verdict", "folds"}, {}, 1};
    for (const FabricMeasures& one : all) {
        const auto band = drape_band(one.name);
        table.rows.push_back({one.name, percent(one.drape.coefficient),
                              band ? cat(percent(band->least), " to ", percent(band->most)) : "-",
                              band ? verdict(one.drape.coefficient, *band) : "-", cat(one.drape.folds)});
    }
    return table;
}

LabTable strip_table(const std::vector<FabricMeasures>& all) {
    LabTable table{{"fabric", "weight [g/m\u00b2]", "bending length [mm]", "rigidity [\u00b5N m]",
                    "asked [\u00b5N m]", "stretch along warp [%]", "weft [%]", "bias [%]"},
                   {},
                   1};
    for (const FabricMeasures& one : all)
        table.rows.push_back({one.name, figure(1e3 * one.fabric.density, 3),
                              figure(1e3 * one.bending.length, 3), figure(1e6 * one.bending.rigidity, 3),
                              figure(1e6 * one.fabric.bending, 3), percent(one.warp), percent(one.weft),
                              percent(one.bias)});
    return table;
}

std::string measures_csv(const std::vector<FabricMeasures>& all) {
    std::string text =
        "fabric,weight_kg_per_m2,bending_length_m,bending_rigidity_n_m,bending_asked_n_m,warp_strain,weft_"
        "strain,"
        "bias_strain,drape_coefficient,folds\n";
    for (const FabricMeasures& one : all)
        text += cat(one.name, ",", csv_number(one.fabric.density), ",", csv_number(one.bending.length), ",",
                    csv_number(one.bending.rigidity), ",", csv_number(one.fabric.bending), ",",
                    csv_number(one.warp), ",", csv_number(one.weft), ",", csv_number(one.bias), ",",
                    csv_number(one.drape.coefficient), ",", one.drape.folds, "\n");
    return text;
}

std::string claim_of(const std::vector<FabricMeasures>& all) {
    std::string text;
    for (const FabricMeasures& one : all) {
        text += cat(text.empty() ? "drape coefficients: " : ", ", one.name, " ",
                    percent(one.drape.coefficient), " %");
        if (const auto band = drape_band(one.name))
            text += cat(" (", percent(band->least), " to ", percent(band->most), ": ",
                        verdict(one.drape.coefficient, *band), ")");
    }
    return text;
}

}  // namespace

LabResult measure_fabrics(std::span<const std::string> names) {
    std::vector<FabricMeasures> all;
    for (const std::string& name : names) fabric_preset(name);
    for (const FabricPreset& preset : fabric_presets()) {
        if (!names.empty() && std::find(names.begin(), names.end(), preset.name) == names.end()) continue;
        all.push_back(measure_fabric(preset.name, preset.fabric, disc_edge));
    }
    LabResult result;
    result.claim = claim_of(all);
    result.story = {
        "Each preset goes through the tests a textile laboratory would make. A strip is pushed over an edge "
        "until "
        "it hangs 41.5 degrees down (ASTM D1388): half that length is its bending length, and weight times "
        "its "
        "cube the bending rigidity. A sheet is pulled with 20 gf/cm along warp, weft and bias. A disc of 30 "
        "cm, "
        "clamped between two of 18 cm, hangs until it is at rest (Cusick's test): its drape coefficient is "
        "the "
        "share of the overhanging ring that its shadow covers. Triangles are 8 mm wide, which is too coarse "
        "for "
        "folds of cloth whose bending length is no more than that: wool_lycra.",
        "drape's fabrics have one modulus for all directions, so the figures along warp, weft and bias "
        "differ only "
        "by what the mesh does; woven cloth gives way on the bias several times as easily. The stretch is "
        "that of "
        "the stiffness at rest.",
        "cotton, wool, silk, denim, canvas and polyester take their bending from cantilever tests of cloth "
        "of their "
        "weight (Feng and others, 2022: 618 fabrics). That of a plate with the tensile modulus, as "
        "wool_lycra "
        "has it, would be four to thirteen times less: cotton would drape to half the coefficient.",
        "The strip's rigidity comes out a little below the one asked for, as it does of real cloth: a strip "
        "curves across where it bends along, and a narrow one has 1 - nu^2 of a wide one's rigidity, nu "
        "Poisson's ratio."};
    result.figures = {disc_figure(all), bending_figure(all)};
    result.tables = {drape_table(all), strip_table(all)};
    result.csv = {{"fabric", measures_csv(all)}};
    return result;
}

LabResult run_fabric() {
    return measure_fabrics({});
}

}  // namespace drape
