#include <catch2/catch.hpp>

#include "support/cloths.h"
#include "support/forces.h"
#include "support/gradient.h"

using namespace drape;
using namespace drape::test;

namespace {

Surroundings air(const Vec3& wind) {
    return {.gravity = Vec3::Zero(), .air = {.drag = 0.4, .wind = wind}};
}

Points moving(const Cloth& cloth, const Vec3& velocity) {
    return velocity.replicate(1, cloth.vertices());
}

}  // namespace

TEST_CASE("drag holds a sheet back by its area and its speed in the air", "[force]") {
    const Cloth cloth = make_cloth(square(6, "alternating", 2), bare_springs(50));
    const auto drag = make_force("air drag", cloth, air({1, 0, 0}));
    const Points& x = cloth.mesh.rest;
    const Points f = force_at(*drag, x, moving(cloth, {1, -3, 0}));
    CHECK((net_force(f) - Vec3(0, 0.4 * 4 * 3, 0)).norm() < 1e-12);
    CHECK(force_at(*drag, x, moving(cloth, {1, 0, 0})).norm() < 1e-14);  // carried along
    CHECK(drag->energy(x) == 0);
}

TEST_CASE("still air takes energy from a sheet, wind gives it some", "[force]") {
    const Cloth cloth = make_cloth(square(6), bare_springs(50));
    Points f = Points::Zero(3, cloth.vertices());
    const Power still = make_force("air drag", cloth, air(Vec3::Zero()))
                            ->add_all(cloth.mesh.rest, moving(cloth, {0, 2, 0}), 0, f);
    CHECK(still.dissipated == Approx(0.4 * 2 * 2));
    CHECK(still.driven == 0);
    const Power blown = make_force("air drag", cloth, air({5, 0, 0}))
                            ->add_all(cloth.mesh.rest, moving(cloth, {2, 0, 0}), 0, f);
    CHECK(blown.dissipated == 0);
    CHECK(blown.driven == Approx(0.4 * 3 * 2));
}

TEST_CASE("drag's bound is the rate it damps each vertex at", "[force]") {
    const Cloth cloth = make_cloth(square(3), bare_springs(50));
    StepBound bound(cloth.vertices());
    make_force("air drag", cloth, air(Vec3::Zero()))->add_bound(cloth.mesh.rest, bound);
    CHECK((bound.damping - 0.4 * cloth.area).norm() < 1e-15);
    CHECK(bound.stiffness.isZero(0));
    CHECK_FALSE(make_force("air drag", cloth));
}
