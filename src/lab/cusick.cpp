#include "lab/cusick.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/error.h"
#include "lab/cantilever.h"
#include "lab/elastic.h"
#include "lab/equilibrium.h"
#include "mesh/irregular_mesh.h"
#include "simulate/simulation.h"

namespace drape {

namespace {

using Vec2 = Eigen::Vector2d;
using std::numbers::pi;

constexpr double nudge = 1e-4;  // out of the plane at the start, so that folds can form [m]
constexpr int most_folds = 16;
constexpr double drag_rate = 10;  // of the air that brings the disc to rest [1/s]
constexpr double frame = 0.1;     // between looks whether it has [s]
constexpr int most_frames = 100;
constexpr double still = 1e-3;          // no vertex is faster [m/s]
constexpr double shadow_cell = 2.5e-4;  // [m]

void add_circle(std::vector<Vec2>& points, double radius, double edge) {
    const int count = static_cast<int>(std::lround(2 * pi * radius / edge));
    for (int i = 0; i < count; ++i)
        points.emplace_back(radius * std::cos(2 * pi * i / count), radius * std::sin(2 * pi * i / count));
}

Mesh ring(double edge, std::uint64_t seed) {
    const double inner = support_radius - edge;
    std::vector<Vec2> circles;
    add_circle(circles, inner, edge);
    add_circle(circles, support_radius, edge);
    add_circle(circles, disc_radius, edge);
    // triangles between chords and arcs do not count
    const double slack = edge * edge / (8 * support_radius);
    return irregular_mesh(
        circles, [=](const Vec2& p) { return p.norm() < disc_radius - slack && p.norm() > inner; },
        [=](const Vec2&) { return edge; }, seed);
}

double angle_of(const Mesh& mesh, int v) {
    return std::atan2(mesh.rest(2, v), mesh.rest(0, v));
}

// The strongest of the waves round the hem, by how far out it lies.
int folds_of(const Mesh& mesh, const Points& x) {
    std::vector<std::complex<double>> wave(most_folds + 1);
    for (int v = 0; v < mesh.vertices(); ++v) {
        if (std::hypot(mesh.rest(0, v), mesh.rest(2, v)) < disc_radius - 1e-9) continue;
        const double out = std::hypot(x(0, v), x(2, v));
        for (int n = 2; n <= most_folds; ++n)
            wave[static_cast<size_t>(n)] += std::polar(out, n * angle_of(mesh, v));
    }
    const auto strongest = std::max_element(
        wave.begin(), wave.end(), [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); });
    return static_cast<int>(strongest - wave.begin());
}

// From the start until it hangs still, in air that slows it down, as a scene would go.
void drop(Model model, const Points& start, CusickDrape& drape) {
    Setup setup;
    const double density = model.cloths.front().fabric.density;
    setup.model = std::move(model);
    setup.start = {start, Points::Zero(3, start.cols()), 0};
    setup.world = {{0, -standard_gravity, 0}, {.drag = drag_rate * density}};
    setup.frame_rate = 1 / frame;
    setup.frames = most_frames;
    Simulation simulation(std::move(setup));
    while (!drape.at_rest && simulation.frame() < most_frames) {
        const FrameReport report = simulation.advance();
        if (!report.trouble.empty()) throw Error(cat("a disc that drapes: ", report.trouble));
        drape.at_rest = simulation.frame() > 2 && report.fastest < still;
    }
    drape.x = simulation.state().x;
}

}  // namespace

CusickDrape drape_disc(const Fabric& fabric, double edge, std::uint64_t seed) {
    CusickDrape drape;
    drape.mesh = ring(edge, seed);
    Model model = free_cloth(drape.mesh, fabric);
    std::vector<int> clamped;
    Points start = drape.mesh.rest;
    for (int v = 0; v < drape.mesh.vertices(); ++v) {
        const double out = std::hypot(start(0, v), start(2, v)) - support_radius;
        if (out < 1e-9) {
            clamped.push_back(v);
            continue;
        }
        double height = 0;
        for (int n = 2; n <= 9; ++n) height += nudge * std::cos(n * angle_of(drape.mesh, v) + n * n);
        start(1, v) = height * out / (disc_radius - support_radius);
    }
    hold_at_rest(model, clamped);
    // what bends less than it reaches out does not fold: implicit steps go there at once
    if (std::cbrt(fabric.bending / (fabric.density * standard_gravity)) > disc_radius - support_radius) {
        const Equilibrium rest = come_to_rest(model, {0, -standard_gravity, 0}, start);
        drape.x = rest.x;
        drape.at_rest = rest.found;
    } else {
        drop(std::move(model), start, drape);
    }
    drape.folds = folds_of(drape.mesh, drape.x);
    const double flat = shadow_area(drape.mesh.faces, drape.mesh.rest, shadow_cell);
    const double ring_area = pi * (disc_radius * disc_radius - support_radius * support_radius);
    drape.coefficient = 1 + (shadow_area(drape.mesh.faces, drape.x, shadow_cell) - flat) / ring_area;
    return drape;
}

double shadow_area(const Faces& faces, In x, double cell) {
    const Eigen::Array2d low(x.row(0).minCoeff(), x.row(2).minCoeff());
    const Eigen::Array2d high(x.row(0).maxCoeff(), x.row(2).maxCoeff());
    const Eigen::Array2i size = ((high - low) / cell).ceil().cast<int>().max(1);
    std::vector<bool> covered(static_cast<size_t>(size.prod()), false);
    for (Eigen::Index f = 0; f < faces.cols(); ++f) {
        Eigen::Array2d corner[3];
        for (int k = 0; k < 3; ++k)
            corner[k] = (Eigen::Array2d(x(0, faces(k, f)), x(2, faces(k, f))) - low) / cell - 0.5;
        const Eigen::Array2i from = corner[0].min(corner[1]).min(corner[2]).ceil().cast<int>().max(0);
        const Eigen::Array2i to = corner[0].max(corner[1]).max(corner[2]).floor().cast<int>().min(size - 1);
        const auto side = [&](int a, int b, double px, double py) {
            return (corner[b].x() - corner[a].x()) * (py - corner[a].y()) -
                   (corner[b].y() - corner[a].y()) * (px - corner[a].x());
        };
        for (int j = from.y(); j <= to.y(); ++j) {
            for (int i = from.x(); i <= to.x(); ++i) {
                const double s = side(0, 1, i, j), t = side(1, 2, i, j), u = side(2, 0, i, j);
                const bool within = (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
                if (within) covered[static_cast<size_t>(j * size.x() + i)] = true;
            }
        }
    }
    return static_cast<double>(std::count(covered.begin(), covered.end(), true)) * cell * cell;
}

}  // namespace drape
