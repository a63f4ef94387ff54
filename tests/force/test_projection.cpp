// Every force that projects: its sweep against the force itself.
#include <catch2/catch.hpp>
#include <functional>

#include "force/altitude_blend.h"
#include "force/altitude_spring.h"
#include "force/edge_spring.h"
#include "support/altitudes.h"
#include "support/forces.h"
#include "support/membranes.h"

using namespace drape;
using namespace drape::test;

namespace {

// a cloth for each way to project, damped
std::vector<std::pair<std::string, Fabric>> every_fabric() {
    std::vector<std::pair<std::string, Fabric>> fabrics;
    for (const auto& [name, mode] : {std::pair{"blend", AltitudeMode::blend},
                                     {"all", AltitudeMode::all},
                                     {"shortest", AltitudeMode::shortest},
                                     {"compressed", AltitudeMode::compressed}}) {
        fabrics.emplace_back(name, altitude_fabric(mode));
        fabrics.back().second.damping = 0.3;
    }
    fabrics.emplace_back("bend springs", bare_springs(20));
    fabrics.back().second.bending_kind = BendingKind::spring;
    fabrics.back().second.bending = 0.1;
    for (const auto& [name, kind] :
         {std::pair{"stvk", MembraneKind::stvk}, {"neo_hookean", MembraneKind::neo_hookean}}) {
        fabrics.emplace_back(name, membrane_fabric(kind, 20));
        fabrics.back().second.damping = 0.3;
    }
    return fabrics;
}

std::vector<std::unique_ptr<Force>> projecting_forces(const Cloth& cloth) {
    std::vector<std::unique_ptr<Force>> forces;
    for (const ForceKind& kind : force_kinds())
        if (auto force = kind.make(cloth, {}).force; force && force->projects())
            forces.push_back(std::move(force));
    return forces;
}

WeightedPoints weighted(In x, const Eigen::VectorXd& inverse_mass) {
    WeightedPoints points(4, x.cols());
    points.topRows<3>() = x;
    points.row(3) = inverse_mass.transpose();
    return points;
}

// Calls check(name, force, cloth) for every force that projects, on a sheet of 5 x 5 vertices.
void for_each_force(const std::function<void(const std::string&, Force&, const Cloth&)>& check) {
    for (const auto& [name, fabric] : every_fabric()) {
        const Cloth cloth = make_cloth(jittered_square(4, "alternating", 0.2), fabric);
        const auto forces = projecting_forces(cloth);
        // edges and the one that it is named for, or a membrane alone
        CHECK(forces.size() == (fabric.membrane == MembraneKind::none ? 2 : 1));
        for (const auto& force : forces) check(name, *force, cloth);
    }
}

}  // namespace

TEST_CASE("over a short step a sweep moves vertices as the force would, damping included", "[force]") {
    for_each_force([](const std::string& name, Force& force, const Cloth& cloth) {
        Eigen::VectorXd inverse_mass = cloth.mass.cwiseInverse();
        inverse_mass[3] = 0;
        const Points v = random_points(25, 1, 2), start = cloth.mesh.rest + random_points(25, 0.02, 1);
        constexpr double h = 1e-6;
        const Points ahead = start + h * v;
        const WeightedPoints before = weighted(start, inverse_mass);
        WeightedPoints x = weighted(ahead, inverse_mass);
        force.project(x, before, h);
        const Points moved = (x.topRows<3>() - ahead) / (h * h);
        const Points expected = force_at(force, ahead, v) * inverse_mass.asDiagonal();
        CAPTURE(name);
        CHECK((moved - expected).norm() <= 1e-3 * expected.norm());
        CHECK(x.row(3).transpose() == inverse_mass);
        CHECK(x.col(3).head<3>() == ahead.col(3));
    });
}

TEST_CASE("a sweep moves the centre of mass of no free cloth", "[force]") {
    for_each_force([](const std::string& name, Force& force, const Cloth& cloth) {
        const Points start = cloth.mesh.rest + random_points(25, 0.05, 3);
        const WeightedPoints before = weighted(start, cloth.mass.cwiseInverse());
        WeightedPoints x = weighted(start + random_points(25, 0.05, 4), cloth.mass.cwiseInverse());
        const Points ahead = x.topRows<3>();
        force.project(x, before, 0.01);
        const Points moved = x.topRows<3>() - ahead;
        CAPTURE(name);
        CHECK(moved.norm() > 1e-3);
        CHECK((moved * cloth.mass).norm() < 1e-15 * moved.norm());
    });
}

TEST_CASE("a sweep of a long step lowers the energy of a cloth out of shape", "[force]") {
    for_each_force([](const std::string& name, Force& force, const Cloth& cloth) {
        const Points start = cloth.mesh.rest + random_points(25, 0.05, 5);
        const WeightedPoints before = weighted(start, cloth.mass.cwiseInverse());
        WeightedPoints x = before;
        force.project(x, before, 0.1);
        const Points after = x.topRows<3>();
        CAPTURE(name, force.energy(start));
        CHECK(force.energy(after) <= 0.9 * force.energy(start));
    });
}

TEST_CASE("springs and triangles without direction are left where they are", "[force]") {
    const Points point = points_of({{1, 2, 3}, {1, 2, 3}});
    EdgeSprings spring({{0, 1, 0.5, 40, 3}}, 0);
    WeightedPoints x = weighted(point, Eigen::VectorXd::Ones(2));
    spring.project(x, x, 0.01);
    CHECK(x.topRows<3>() == point);
    for (const AltitudeMode mode : {AltitudeMode::blend, AltitudeMode::all, AltitudeMode::shortest}) {
        const Cloth cloth = make_cloth(scalene_triangle(), altitude_fabric(mode));
        const auto force = make_force("altitude springs", cloth);
        for (const Points& collapsed : collapsed_triangles()) {
            WeightedPoints y = weighted(collapsed, cloth.mass.cwiseInverse());
            const WeightedPoints before = y;
            force->project(y, before, 0.01);
            CHECK(y.allFinite());
        }
    }
    for (const MembraneKind kind : membrane_kinds) {
        const Cloth cloth = make_cloth(scalene_triangle(), membrane_fabric(kind, 20));
        Membrane membrane(cloth);
        for (const Points& collapsed : collapsed_triangles()) {
            WeightedPoints y = weighted(collapsed, cloth.mass.cwiseInverse());
            const WeightedPoints before = y;
            membrane.project(y, before, 0.01);
            CHECK(y.allFinite());
        }
    }
}
