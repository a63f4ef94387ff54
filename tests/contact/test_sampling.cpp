#include "contact/sampling.h"

#include <catch2/catch.hpp>
#include <set>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

namespace {

Vec3 position(const ContactPoint& point, In x) {
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) sum += point.weight[k] * x.col(point.vertex[k]);
    return sum;
}

Model two_cloths() {
    Model model = model_of(square(2), bare_springs(10));
    add_cloth(model, make_cloth(jittered_square(4, "one_way", 0.3), bare_springs(10)));
    return model;
}

}  // namespace

TEST_CASE("contact points at every level share out the cloth's area and each corner's mass", "[contact]") {
    const Model model = two_cloths();
    for (const Cloth& cloth : model.cloths) {
        for (const int level : {1, 2, 3, 5, 12}) {
            CAPTURE(cloth.first, level);
            double area = 0;
            Eigen::VectorXd carried = Eigen::VectorXd::Zero(model.vertices());
            for (const ContactPoint& point : contact_points(model, cloth, level)) {
                area += point.area;
                double sum = 0, inverse_mass = 0;
                for (int k = 0; k < 3; ++k) {
                    sum += point.weight[k];
                    inverse_mass += point.weight[k] * point.weight[k] * model.inverse_mass[point.vertex[k]];
                    carried[point.vertex[k]] += point.weight[k] * point.area;
                    CHECK((point.weight[k] > 0) == (k < point.corners));
                }
                CHECK(sum == Approx(1).epsilon(1e-15));
                CHECK(point.inverse_mass == Approx(inverse_mass));
            }
            CHECK(area == Approx(cloth.area.sum()).epsilon(1e-13));
            CHECK((carried.segment(cloth.first, cloth.vertices()) - cloth.area).norm() < 1e-14);
            CHECK(carried.sum() == Approx(cloth.area.sum()));  // nothing for the other cloth
        }
    }
}

TEST_CASE("contact points are the lattice of each triangle, shared ones counted once", "[contact]") {
    const Model model = two_cloths();
    const Cloth& cloth = model.cloths[1];
    const auto edges = static_cast<int>(cloth.topology.edges.size());
    for (const int level : {1, 2, 3, 6}) {
        CAPTURE(level);
        const std::vector<ContactPoint> points = contact_points(model, cloth, level);
        const int inner = (level - 1) * (level - 2) / 2;
        CHECK(static_cast<int>(points.size()) ==
              cloth.vertices() + (level - 1) * edges + inner * cloth.mesh.triangles());
        Points x = Points::Zero(3, model.vertices());
        x.rightCols(cloth.vertices()) = cloth.mesh.rest;
        std::set<std::array<long, 3>> places;
        for (const ContactPoint& point : points) {
            const Vec3 p = position(point, x) * 1e9;
            places.insert({std::lround(p.x()), std::lround(p.y()), std::lround(p.z())});
        }
        CHECK(places.size() == points.size());
    }
}

TEST_CASE("points that only pinned vertices carry are left out, and pins do not count as mass", "[contact]") {
    Model model = model_of(equilateral_triangle(), bare_springs(10));
    PinGroup pinned;
    pinned.vertices = {0, 1};
    pinned.anchors = model.cloths[0].mesh.rest.leftCols(2);
    add_pins(model, pinned);
    const std::vector<ContactPoint> points = contact_points(model, model.cloths[0], 2);
    CHECK(points.size() == 3);  // of 6: two pinned corners and the middle between them are gone
    for (const ContactPoint& point : points) {
        const double free_weight = point.corners == 1 ? 1 : 0.5;
        CHECK(point.inverse_mass == Approx(free_weight * free_weight * model.inverse_mass[2]));
    }
}
