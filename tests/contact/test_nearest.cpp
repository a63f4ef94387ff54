#include "contact/nearest.h"

#include <catch2/catch.hpp>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

namespace {

Vec3 way_of(const Nearest& nearest, const Points& x) {
    Vec3 way = Vec3::Zero();
    for (int i = 0; i < 4; ++i) way += nearest.weight[i] * x.col(i);
    return way;
}

// The least distance over a lattice of places on both pieces.
double lattice_distance(const Points& x, bool edges) {
    constexpr int parts = 60;
    double least = INFINITY;
    for (int i = 0; i <= parts; ++i)
        for (int j = 0; j <= (edges ? parts : parts - i); ++j) {
            const double s = double(i) / parts, t = double(j) / parts;
            const Vec3 way = edges
                                 ? Vec3((1 - s) * x.col(0) + s * x.col(1) - (1 - t) * x.col(2) - t * x.col(3))
                                 : Vec3(x.col(0) - (1 - s - t) * x.col(1) - s * x.col(2) - t * x.col(3));
            least = std::min(least, way.norm());
        }
    return least;
}

}  // namespace

TEST_CASE("the nearest places of two pieces of cloth are on them and no others are nearer", "[contact]") {
    int free[3] = {};
    for (unsigned seed = 0; seed < 400; ++seed) {
        const Points x = random_points(4, 1, seed);
        for (const bool edges : {false, true}) {
            const Nearest nearest = edges ? nearest_of_edges(x.col(0), x.col(1), x.col(2), x.col(3))
                                          : nearest_to_triangle(x.col(0), x.col(1), x.col(2), x.col(3));
            const Vec3 way = way_of(nearest, x);
            CHECK(nearest.distance == Approx(way.norm()).margin(1e-12));
            CHECK((nearest.distance * nearest.normal - way).norm() < 1e-12);
            double sum = 0, size = 0;
            for (const double weight : nearest.weight) {
                sum += weight;
                size += std::abs(weight);
            }
            CHECK(sum == Approx(0).margin(1e-14));
            CHECK(size == Approx(2));
            const double seen = lattice_distance(x, edges);
            CHECK(nearest.distance <= seen + 1e-12);
            CHECK(nearest.distance > seen - 0.05);
            // where a place is free to move, moving it leads no nearer
            for (int k = 0; k < nearest.free; ++k) {
                Vec3 shift = Vec3::Zero();
                for (int i = 0; i < 4; ++i) shift += nearest.slope[k][i] * x.col(i);
                CHECK(std::abs(shift.dot(way)) < 1e-12);
            }
            ++free[nearest.free];
        }
    }
    for (const int count : free) CHECK(count > 20);
}

TEST_CASE("parallel and crossing edges and a triangle without area have a distance", "[contact]") {
    const Vec3 o(0, 0, 0), x(1, 0, 0);
    CHECK(nearest_of_edges(o, x, Vec3(0.5, 0, 2), Vec3(3, 0, 2)).distance == 2);
    CHECK(nearest_of_edges(o, x, Vec3(2, 0, 0), Vec3(3, 0, 0)).distance == 1);
    const Nearest crossing = nearest_of_edges(o, x, Vec3(0.5, -1, 0), Vec3(0.5, 1, 0));
    CHECK(crossing.distance == 0);
    CHECK(crossing.normal == Vec3::Zero());
    CHECK(nearest_to_triangle(Vec3(1.5, 3, 0), o, x, Vec3(2, 0, 0)).distance == 3);
}
