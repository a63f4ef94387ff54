#include "lab/validation.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "lab/hanging.h"
#include "lab/sliding.h"

namespace drape {

namespace {

constexpr double gravity = 9.81;  // [m/s^2]

}  // namespace

HangingTip loaded_tip(std::string_view mesh, BendingKind kind, double load, int divisions) {
    const double length = loaded_length, square = length * length;
    Fabric fabric;
    fabric.membrane = MembraneKind::stvk;
    fabric.membrane_poisson = fabric.poisson = 0;
    fabric.bending_kind = kind;
    fabric.bending = 1e-5;
    fabric.density = load * fabric.bending / (square * length * gravity);
    // by 1e-4 of its length where it carries all its weight
    fabric.stretch = 1e4 * std::max(load, 10.0) * fabric.bending / square;
    return bend_strip(clamped_strip(mesh, {length, length / 10, divisions}), fabric, gravity);
}

// Bessel's zeros: half of them times sqrt(g / L).
std::vector<Check> check_curtain(int rows) {
    constexpr double length = 1, reference[] = {1.20241, 2.76004, 4.32686};
    Fabric fabric;
    fabric.density = 0.2;
    fabric.stretch = 2e5;  // its weight stretches it by a hundred thousandth
    const std::vector<double> found =
        swing_frequencies(hanging_sheet(length * 4 / rows, length, 4, rows), fabric, gravity);
    std::vector<Check> checks;
    for (size_t i = 0; i < std::size(reference); ++i)
        checks.push_back({cat("curtain, frequency ", i + 1, " / sqrt(g / L)"), "edge springs", reference[i],
                          found[i] / std::sqrt(gravity / length), 0.01, cat(rows, " rows")});
    return checks;
}

Check check_strip(const std::string& on, const Fabric& fabric, int rows) {
    constexpr double length = 1;
    const double expected = fabric.density * gravity * length * length / (2 * fabric.stretch);
    const double found = hanging_stretch(hanging_sheet(length * 2 / rows, length, 2, rows), fabric, gravity);
    return {"strip, stretch by its weight [mm]", on, 1e3 * expected, 1e3 * found, 0.005, cat(rows, " rows")};
}

std::vector<Check> check_slope() {
    constexpr double friction = 0.5, holds = 0.49, slides = 0.8;
    return {
        {"slope, tan 0.49 under friction 0.5: way in 2 s [mm]", "verlet", 0,
         1e3 * slide_down(holds, friction).way, 1, "4 x 4"},
        {"slope, tan 0.8 over friction 0.5: acceleration [m/s\u00b2]", "verlet",
         sliding_acceleration(slides, friction), slide_down(slides, friction).acceleration, 0.01, "4 x 4"}};
}

}  // namespace drape
