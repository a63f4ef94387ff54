#include <catch2/catch.hpp>

#include "support/cloths.h"
#include "support/forces.h"
#include "support/gradient.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("gravity pulls every vertex by its mass and the sheet by its weight", "[force]") {
    const Cloth cloth = make_cloth(jittered_square(5, "one_way", 0.3), bare_springs(50, 0.3));
    const Surroundings world{.gravity = {1, -9, 2}, .air = {}};
    const auto gravity = make_force("gravity", cloth, world);
    const Points x = random_points(cloth.vertices(), 1, 1), f = force_at(*gravity, x);
    CHECK((f - world.gravity * cloth.mass.transpose()).norm() == 0);
    CHECK((net_force(f) - 0.3 * world.gravity).norm() < 1e-12);  // 1 m^2 of 0.3 kg/m^2
    const Points raised = x.colwise() + Vec3(0, 2, 0);
    CHECK(gravity->energy(raised) - gravity->energy(x) == Approx(0.3 * 9 * 2));
}

TEST_CASE("without gravity there is no gravity to run", "[force]") {
    CHECK_FALSE(
        make_force("gravity", make_cloth(square(2), bare_springs(50)), {.gravity = {0, 0, 0}, .air = {}}));
}
