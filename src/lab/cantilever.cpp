#include "lab/cantilever.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/names.h"
#include "lab/elastic.h"
#include "lab/equilibrium.h"
#include "mesh/irregular_mesh.h"
#include "mesh/pattern.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double tilt_deg = 41.5;  // of ASTM D1388's sloping plane
constexpr double fine_share = 2;   // how much longer edges are at the tip of an adaptive strip

Mesh on_grid(std::string_view pattern, const StripSize& size) {
    const double edge = size.length / size.divisions;
    const int rows = std::max(1, static_cast<int>(std::lround(size.width / edge)));
    Mesh mesh = make_pattern(pattern, {size.length + edge, size.width, size.divisions + 1, rows});
    mesh.rest.row(0).array() += size.length / 2 - edge / 2;
    // the clamp's column is at 0 to the last bit
    for (int v = 0; v < mesh.vertices(); ++v)
        if (std::abs(mesh.rest(0, v)) < 1e-9 * edge) mesh.rest(0, v) = 0;
    return mesh;
}

// Rows of equilateral triangles across the strip, which is as wide as some of them are.
Mesh in_rows(const StripSize& size) {
    const double edge = size.length / size.divisions, side = edge / std::sqrt(0.75);
    const int columns = std::max(1, static_cast<int>(std::lround(size.width / side)));
    Mesh mesh = make_pattern("equilateral", {columns * side, size.length + edge, columns, 1});
    mesh.rest.row(0).swap(mesh.rest.row(2));
    mesh.faces.row(1).swap(mesh.faces.row(2));  // front side up
    mesh.rest.row(0).array() += size.length / 2 - edge / 2;
    for (int v = 0; v < mesh.vertices(); ++v)
        if (std::abs(mesh.rest(0, v)) < 1e-9 * edge) mesh.rest(0, v) = 0;
    return mesh;
}

Mesh irregular(const StripSize& size, double share) {
    const double edge = size.length / size.divisions, half = size.width / 2;
    // from 2 / (1 + share) of an edge at the clamp to share times that at the tip
    const SizeField edge_length = [&](const Vec2& p) {
        const double along = std::clamp(p.x() / size.length, 0.0, 1.0);
        return edge * 2 / (1 + share) * (1 + (share - 1) * along);
    };
    const double clamped = edge_length({0, 0});
    std::vector<Vec2> fixed = points_round({{-clamped, -half},
                                            {0, -half},
                                            {size.length, -half},
                                            {size.length, half},
                                            {0, half},
                                            {-clamped, half}},
                                           edge_length);
    std::vector<Vec2> clamp = points_between({0, -half}, {0, half}, edge_length);
    fixed.insert(fixed.end(), clamp.begin() + 1, clamp.end());
    const Region inside = [&](const Vec2& p) {
        return p.x() > -clamped && p.x() < size.length && std::abs(p.y()) < half;
    };
    return irregular_mesh(fixed, inside, edge_length, size.seed);
}

}  // namespace

Mesh clamped_strip(std::string_view mesh, const StripSize& size) {
    const double share = mesh == "adaptive" ? fine_share : 1;
    StripSize beyond = size;  // from the held row's far side on
    beyond.length /= 1 + 1 / ((1 + share) * size.divisions);
    const double held = beyond.length / size.divisions * 2 / (1 + share);
    Mesh strip = mesh == "adaptive" || mesh == "pseudo_random" ? irregular(beyond, share)
                 : mesh == "equilateral"                       ? in_rows(beyond)
                                                               : on_grid(mesh, beyond);
    strip.rest.row(0).array() += held / 2;
    return strip;
}

HangingTip bend_strip(const Mesh& strip, const Fabric& fabric, double gravity) {
    Model model = free_cloth(strip, fabric);
    std::vector<int> clamped;
    const double held = -strip.rest.row(0).minCoeff() * (1 + 1e-9);
    for (int v = 0; v < strip.vertices(); ++v)
        if (strip.rest(0, v) <= held) clamped.push_back(v);
    hold_at_rest(model, clamped);
    const Equilibrium rest = come_to_rest(model, {0, -gravity, 0}, strip.rest);
    HangingTip tip;
    tip.at_rest = rest.found;
    const double end = strip.rest.row(0).maxCoeff(), width = strip.rest.row(2).maxCoeff();
    int count = 0;
    for (int v = 0; v < strip.vertices(); ++v) {
        if (strip.rest(0, v) >= 0 && std::abs(strip.rest(2, v)) < width / 2)
            tip.places.push_back({rest.x(0, v), -rest.x(1, v)});
        if (strip.rest(0, v) < end - 1e-9) continue;
        tip.reach += rest.x(0, v);
        tip.drop -= rest.x(1, v);
        ++count;
    }
    tip.reach /= count;
    tip.drop /= count;
    std::sort(tip.places.begin(), tip.places.end());
    return tip;
}

// The secant method on the logarithms of gravity and slope, which grow about alike.
BendingLength measure_bending_length(const Fabric& fabric) {
    const double wanted = std::log(std::tan(tilt_deg * std::numbers::pi / 180));
    StripSize size;
    size.length = 2 * std::cbrt(fabric.bending / (fabric.density * standard_gravity));
    size.width = size.length / 4;
    const Mesh strip = clamped_strip("alternating", size);
    const auto slope = [&](double log_gravity) {
        return std::log(bend_strip(strip, fabric, std::exp(log_gravity)).slope());
    };
    double before = std::log(standard_gravity), now = before + 0.1;
    double slope_before = slope(before), slope_now = slope(now);
    for (int i = 0; i < 6 && std::abs(slope_now - wanted) > 1e-5; ++i) {
        const double next = now + (wanted - slope_now) * (now - before) / (slope_now - slope_before);
        before = now, slope_before = slope_now;
        now = next, slope_now = slope(next);
    }
    const double c = size.length * std::cbrt(std::exp(now) / standard_gravity) / 2;
    return {c, fabric.density * standard_gravity * c * c * c};
}

}  // namespace drape
