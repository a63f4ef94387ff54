#include "force/edge_slope.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "support/sheets.h"

using namespace drape;
using namespace drape::test;

namespace {

double found_slope(const EdgeSlope& slope, const Points& lifted) {
    double sum = 0;
    for (size_t i = 0; i < slope.vertex.size(); ++i)
        sum += slope.weight[static_cast<Eigen::Index>(i)] * lifted(1, slope.vertex[i]);
    return sum;
}

}  // namespace

TEST_CASE("the slope across an edge is exact for quadratic functions on every mesh", "[force]") {
    for (const Sheet& sheet : every_sheet(8)) {
        CAPTURE(sheet.name);
        const Topology topology = build_topology(sheet.mesh.faces, sheet.mesh.vertices());
        const Points bent = lifted(sheet.mesh, [](double u, double v) {
            return 3 + 0.2 * u - v + 0.35 * u * u - 0.4 * u * v + 0.55 * v * v;
        });
        const auto gradient = [](const Vec3& p) {
            return Vec3(0.2 + 0.7 * p.x() - 0.4 * p.z(), 0, -1 - 0.4 * p.x() + 1.1 * p.z());
        };
        double worst = 0;
        for (const Edge& edge : topology.edges) {
            if (edge.face_count != 2) continue;
            const EdgeSlope slope = edge_slope(sheet.mesh, topology, edge);
            CHECK(slope.complete);
            worst = std::max(worst, slope.condition);
            const Vec3 a = sheet.mesh.rest.col(edge.vertex[0]), b = sheet.mesh.rest.col(edge.vertex[1]);
            const Vec3 inside = sheet.mesh.rest.col(edge.opposite[0]);
            Vec3 across = (b - a).cross(Vec3::UnitY()).normalized();
            if (across.dot(inside - a) > 0) across = -across;
            CHECK(found_slope(slope, bent) == Approx(across.dot(gradient((a + b) / 2))).margin(1e-11));
        }
        CHECK(worst < 60);
    }
}

TEST_CASE("four vertices tell the slope where triangles are half turns of each other", "[force]") {
    const Mesh mesh = square(6, "one_way");
    const Topology topology = build_topology(mesh.faces, mesh.vertices());
    for (const Edge& edge : topology.edges)
        if (edge.face_count == 2) CHECK(edge_slope(mesh, topology, edge).vertex.size() == 4);
}

TEST_CASE("a strip one triangle wide tells what it can and feels no moving or tilting", "[force]") {
    const Mesh mesh = make_pattern("alternating", {0.9, 0.1, 9, 1});
    const Topology topology = build_topology(mesh.faces, mesh.vertices());
    const Points tilted = lifted(mesh, [](double u, double v) { return 3 + 0.5 * u - v; });
    int incomplete = 0;
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 2) continue;
        const EdgeSlope slope = edge_slope(mesh, topology, edge);
        incomplete += !slope.complete;
        CHECK(slope.weight.sum() == Approx(0).margin(1e-12));
        CHECK(std::abs(found_slope(slope, tilted)) < std::sqrt(1.25) + 1e-9);
    }
    CHECK(incomplete == 8);  // across its rungs; half turns tell all across its diagonals
}

TEST_CASE("cloth that is curved at rest is taken as the flat panel it is cut from", "[force]") {
    // flat facets along z between the rulings of a cylinder: chords, that unroll to a narrower sheet
    const double radius = 0.4, width = 1.0 / 8;
    Mesh panel = square(8, "alternating"), skirt = panel;
    skirt.rest = rolled(panel, radius, 0);
    panel.rest.row(0) *= 2 * radius * std::sin(width / 2 / radius) / width;
    const Topology topology = build_topology(panel.faces, panel.vertices());
    for (const Edge& edge : topology.edges) {
        if (edge.face_count != 2) continue;
        const EdgeSlope flat = edge_slope(panel, topology, edge), curved = edge_slope(skirt, topology, edge);
        REQUIRE(flat.vertex == curved.vertex);
        CHECK((flat.weight - curved.weight).norm() < 1e-10 * flat.weight.norm());
    }
}
