#include "lab/fit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "base/numbers.h"
#include "io/read_file.h"
#include "lab/cantilever.h"
#include "lab/elasticity.h"
#include "lab/plot.h"
#include "mesh/pattern.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

constexpr std::uint64_t largest_file = 16 << 20;  // [bytes]
constexpr int strip_divisions = 24;
constexpr int rounds = 3;  // each takes out all but a hundredth of what is left

std::string trimmed(std::string text) {
    text.erase(std::min(text.find('#'), text.size()));
    const auto from = text.find_first_not_of(" \t\r"), to = text.find_last_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

bool read_number(const std::string& text, double& value) {
    const std::string word = trimmed(text);
    const auto [end, trouble] = std::from_chars(word.data(), word.data() + word.size(), value);
    return trouble == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

bool read_sample(const std::string& line, std::array<double, 2>& sample) {
    const auto comma = line.find_first_of(",;\t");
    return comma != std::string::npos && read_number(line.substr(0, comma), sample[0]) &&
           read_number(line.substr(comma + 1), sample[1]);
}

double warp_modulus(const Fabric& fabric) {
    return measure_elasticity(make_pattern("alternating", {1, 1, strip_divisions, strip_divisions}), fabric)
        .stretch_modulus(0);
}

LabFigure fit_figure(const StretchCurve& curve, const FabricFit& fit) {
    const PanelGrid grid{1, 1, 560, 320};
    LabFigure figure{"fit",
                     "Force per width against strain: measured, and of the fitted fabric on a virtual sheet.",
                     grid.width(),
                     grid.height(),
                     data_block("m", curve.samples),
                     grid.begin("A fabric for a measured stretch curve") + plain_panel()};
    figure.plot +=
        cat("set xlabel 'strain [%]'\nset ylabel 'force per width [N/m]'\nset key left top\n",
            "plot $m using (100*$1):2 with linespoints pt 7 ps 0.8 lw 2 lc rgb '", plot_colour(0),
            "' title 'measured', ", fit.virtual_modulus, "/100*x with lines lw 2 dt (6,4) lc rgb '",
            plot_colour(1), "' title 'fitted'\nunset multiplot\n");
    return figure;
}

}  // namespace

StretchCurve parse_stretch_curve(const std::string& text, const std::string& path) {
    StretchCurve curve;
    std::istringstream lines(text);
    std::string line;
    bool named = false;
    for (int number = 1; std::getline(lines, line); ++number) {
        line = trimmed(line);
        if (line.empty()) continue;
        std::array<double, 2> sample{};
        if (read_sample(line, sample)) {
            if (sample[0] < 0 || sample[1] < 0)
                throw Error(cat(path, ":", number, ": strain and force per width must not be negative"));
            curve.samples.push_back(sample);
        } else if (curve.samples.empty() && !named) {
            named = true;
        } else {
            throw Error(cat(path, ":", number, ": expected \"strain,force per width\", two numbers, found \"",
                            line.substr(0, 40), "\""));
        }
    }
    const auto pulled = [](const auto& sample) { return sample[0] > 0 && sample[1] > 0; };
    if (std::count_if(curve.samples.begin(), curve.samples.end(), pulled) < 2)
        throw Error(cat(path, ": a stretch curve needs two samples with strain and force over 0"));
    return curve;
}

StretchCurve read_stretch_curve(const std::string& path) {
    return parse_stretch_curve(read_file(path, largest_file), path);
}

// Stretch: all is linear. Bending: what a mesh leaves of the rigidity hardly depends on how much there is.
FabricFit fit_fabric(const StretchCurve& curve, double bending_length, double density) {
    double product = 0, square = 0, largest = 0;
    for (const auto& [strain, force] : curve.samples) {
        product += strain * force;
        square += strain * strain;
        largest = std::max(largest, force);
    }
    FabricFit fit;
    fit.modulus = product / square;
    for (const auto& [strain, force] : curve.samples)
        fit.off += std::pow((force - fit.modulus * strain) / largest, 2);
    fit.off = std::sqrt(fit.off / static_cast<double>(curve.samples.size()));

    Fabric fabric;
    fabric.density = density;
    fabric.altitude = AltitudeMode::blend;
    fabric.stretch = fit.modulus;
    fabric.stretch *= fit.modulus / warp_modulus(fabric);
    fabric.bending_kind = BendingKind::plate;
    fabric.bending = density * standard_gravity * std::pow(bending_length, 3);
    fit.virtual_length = measure_bending_length(fabric).length;
    for (int i = 0; i < rounds; ++i) {
        fabric.bending *= std::pow(bending_length / fit.virtual_length, 3);
        fit.virtual_length = measure_bending_length(fabric).length;
    }
    fit.stretch = fabric.stretch;
    fit.bending = fabric.bending;
    fit.virtual_modulus = warp_modulus(fabric);
    return fit;
}

LabResult run_fit(const FitRequest& request) {
    const StretchCurve curve = read_stretch_curve(request.curve);
    const FabricFit fit = fit_fabric(curve, request.bending_length, request.density);
    LabResult result;
    result.claim = cat(
        "fabric = { density = ", figure(request.density, 4),
        ", stretch = { model = \"membrane\", value = ", figure(fit.stretch, 4),
        " }, altitude = \"blend\", bending = { kind = \"plate\", value = ", figure(fit.bending, 4), " } }");
    result.story = {
        "The straight line through the origin nearest to the curve gives the modulus along warp, and weight "
        "times the "
        "bending length's cube the rigidity. A sheet of springs, cut by alternating diagonals, is not quite "
        "as stiff "
        "along warp as its fabric says, and a narrow strip not as one across: both constants are set so that "
        "a virtual "
        "sheet and a "
        "virtual cantilever measure what was asked.",
        cat("Cloth stiffens as it is pulled and springs do not: the curve is off the line by ",
            figure(100 * fit.off, 2), " % of its largest force (RMS).")};
    result.figures = {fit_figure(curve, fit)};
    result.tables = {{{"", "measured", "virtual", "constant in the fabric"},
                      {{"modulus along warp [N/m]", figure(fit.modulus, 4), figure(fit.virtual_modulus, 4),
                        figure(fit.stretch, 4)},
                       {"bending length [mm]", figure(1e3 * request.bending_length, 4),
                        figure(1e3 * fit.virtual_length, 4), cat(figure(fit.bending, 4), " N m")}},
                      1}};
    std::string text = "strain,measured_n_per_m,fitted_n_per_m\n";
    for (const auto& [strain, force] : curve.samples)
        text += cat(csv_number(strain), ",", csv_number(force), ",", csv_number(fit.virtual_modulus * strain),
                    "\n");
    result.csv = {{"fit", text}};
    return result;
}

}  // namespace drape
