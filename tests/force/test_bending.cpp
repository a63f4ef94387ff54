#include <catch2/catch.hpp>

#include "force/bend_hinge.h"
#include "force/bend_plate.h"
#include "force/edge_spring.h"
#include "force/kinds.h"
#include "support/forces.h"
#include "support/meshes.h"
#include "support/sheets.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("a fabric gets the bending it asks for, or none and the reason", "[force]") {
    const auto made = [](BendingKind kind, double bending) {
        return make_bending(make_cloth(square(2), bending_fabric(kind, bending)), {});
    };
    CHECK(dynamic_cast<BendPlate*>(made(BendingKind::plate, 1).force.get()));
    CHECK(dynamic_cast<BendHinge*>(made(BendingKind::hinge, 1).force.get()));
    CHECK(dynamic_cast<EdgeSprings*>(made(BendingKind::spring, 1).force.get()));
    for (const MadeForce& none : {made(BendingKind::none, 1), made(BendingKind::plate, 0)}) {
        CHECK_FALSE(none.force);
        CHECK(none.because.find("no bending") != std::string::npos);
    }
}

TEST_CASE("bend springs span every inner edge from corner to corner, a share as stiff as the edge",
          "[force]") {
    const Cloth cloth = make_cloth(two_triangles(), bending_fabric(BendingKind::spring, 0.1));
    REQUIRE(cloth.network.bends.size() == 1);
    const Spring& bend = cloth.network.bends[0];
    CHECK(bend.a == 1);
    CHECK(bend.b == 3);
    CHECK(bend.rest_length == Approx(std::sqrt(2.0)));
    CHECK(bend.stiffness == Approx(0.1 * 50));
    const auto force = make_force("bending", cloth);
    Points x = cloth.mesh.rest;
    CHECK(force->energy(x) < 1e-28);
    x.col(3) = Vec3(1, 0, 1);  // folded square: the span is 1
    CHECK(force->energy(x) == Approx(0.5 * 5 * std::pow(1 - std::sqrt(2.0), 2)));
}
