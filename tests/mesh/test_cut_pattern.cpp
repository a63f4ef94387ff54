// Every pattern over every region: to the border, without slivers.
#include <catch2/catch.hpp>
#include <numbers>

#include "mesh/pattern.h"
#include "mesh/quality.h"
#include "support/meshes.h"

using namespace drape;

namespace {

using Vec2 = Eigen::Vector2d;

const std::vector<Vec2> ell{{0, 0}, {1.2, 0}, {1.2, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}};
const std::vector<Vec2> kite{{0, -0.6}, {0.5, 0.1}, {0, 0.4}, {-0.5, 0.1}};

struct Covered {
    std::string over;
    std::vector<Vec2> outline;
    double area;
    int loops, sides;  // of a disc: not counted
};

double distance_to_side(const Vec2& p, const Vec2& a, const Vec2& b) {
    const double at = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - at * (b - a)).norm();
}

// how far a border vertex is off the outline
double off(const Covered& region, const Vec3& p) {
    const Vec2 at(p.x(), p.z());
    if (region.over == "disc") return std::abs(at.norm() - 0.5);
    if (region.over == "annulus") return std::min(std::abs(at.norm() - 0.5), std::abs(at.norm() - 0.2));
    double nearest = 1;
    for (size_t i = 0; i < region.outline.size(); ++i)
        nearest = std::min(nearest, distance_to_side(at, region.outline[i],
                                                     region.outline[(i + 1) % region.outline.size()]));
    return nearest;
}

}  // namespace

TEST_CASE("every pattern fills a disc and an annulus and an outline to the border without slivers",
          "[mesh]") {
    const double pi = std::numbers::pi;
    const Covered regions[] = {{"disc", {}, pi / 4, 1, 0},
                               {"annulus", {}, pi * (0.25 - 0.04), 2, 0},
                               {"outline", ell, 1.2 * 0.5 + 0.25, 1, 6},
                               {"outline", kite, 0.5, 1, 4}};
    for (const PatternKind& kind : pattern_kinds()) {
        for (const Covered& region : regions) {
            for (const auto& [columns, rows] : {std::pair{16, 16}, {23, 19}}) {
                CAPTURE(kind.name, region.over, region.area, columns);
                PatternSize size{1, 1, columns, rows};
                size.over = region.over;
                size.hole = 0.4;
                size.outline = region.outline;
                size.finer.points = {{0.1, 0.3}};
                const Mesh mesh = make_pattern(kind.name, size);
                const Topology topology = build_topology(mesh.faces, mesh.vertices());
                const MeshQuality quality = measure_quality(mesh, topology);
                CHECK(quality.components == 1);
                CHECK(quality.non_manifold_edges == 0);
                CHECK(quality.boundary_loops == region.loops);
                CHECK(quality.vertices - quality.edges + quality.triangles == 2 - region.loops);
                // chords are inside arcs, by (edge / radius)^2 / 6
                if (region.sides > 0)
                    CHECK(quality.area == Approx(region.area).epsilon(1e-9));
                else
                    CHECK(quality.area == Approx(region.area).epsilon(0.015));
                CHECK(quality.smallest_angle_deg > 20);  // measured: 23.6 and more, mostly 30
                int corners = 0;
                for (const auto& loop : topology.boundary_loops) {
                    for (const int v : loop) {
                        CHECK(off(region, mesh.rest.col(v)) < 1e-12);
                        for (const Vec2& corner : region.outline)
                            corners += Vec2(mesh.rest(0, v), mesh.rest(2, v)) == corner;
                    }
                }
                CHECK(corners == region.sides);
                for (int f = 0; f < mesh.triangles(); ++f) {
                    const Vec3 a = mesh.rest.col(mesh.faces(0, f));
                    CHECK(
                        (mesh.rest.col(mesh.faces(1, f)) - a).cross(mesh.rest.col(mesh.faces(2, f)) - a).y() >
                        0);
                }
            }
        }
    }
}

TEST_CASE("the middle of a disc is the grid that fills its square", "[mesh]") {
    PatternSize size{1, 1, 16, 16};
    const Mesh grid = make_pattern("one_way", size);
    size.over = "disc";
    const Mesh disc = make_pattern("one_way", size);
    int same = 0;
    for (int v = 0; v < disc.vertices(); ++v)
        for (int w = 0; w < grid.vertices(); ++w) same += disc.rest.col(v) == grid.rest.col(w);
    CHECK(same > 140);  // of the 193 that are in the disc
}

TEST_CASE("outlines that enclose nothing sound are refused", "[mesh]") {
    PatternSize size;
    size.over = "outline";
    const auto says = [&](const std::vector<Vec2>& corners) {
        size.outline = corners;
        return error_of([&] { make_pattern("alternating", size); });
    };
    CHECK_THAT(says({{0, 0}, {1, 0}}), Catch::Contains("at least 3 corners, got 2"));
    CHECK_THAT(says({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), Catch::Contains("after corners 1 and 3 meet"));
    CHECK_THAT(says({{0, 0}, {1, 0}, {2, 0}}), Catch::Contains("meet"));
    CHECK_THAT(says({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),
               Catch::Contains("corner 3 stands on the one before it"));
    CHECK_THAT(says({{0, 0}, {1, 0}, {NAN, 0}}), Catch::Contains("corner 3 is not finite"));
    size = {1, 2, 8, 8};
    size.over = "disc";
    CHECK_THAT(error_of([&] { make_pattern("crossed", size); }), Catch::Contains("square size, got 1 x 2"));
    size = {1, 1, 8, 8};
    size.over = "annulus";
    size.hole = 1;
    CHECK_THAT(error_of([&] { make_pattern("crossed", size); }), Catch::Contains("narrower than its 1 m"));
    // a needle is too sharp to be filled
    size.over = "outline";
    size.outline = {{0, 0}, {1, 0}, {0.5, 1e-12}, {0, 1}};
    CHECK_THAT(error_of([&] { make_pattern("pseudo_random", size); }), Catch::Contains("too narrow"));
}
