#include "force/altitude_blend.h"

#include <catch2/catch.hpp>

#include "support/altitudes.h"
#include "support/forces.h"

using namespace drape;
using namespace drape::test;

namespace {

Cloth blended(double damping = 0) {
    Fabric fabric = altitude_fabric(AltitudeMode::blend);
    fabric.damping = damping;
    return make_cloth(scalene_triangle(), fabric);
}

double weight_of(const Cloth& cloth) {
    return cloth.network.altitudes[0].common_weight;
}

}  // namespace

TEST_CASE("the blend is at ease at rest, wherever the triangle lies and however it is turned", "[force]") {
    const Cloth cloth = blended();
    const AltitudeBlend blend(cloth);
    const Mat3 turn = rotation_from_degrees({20, 130, -70});
    const Points x = (turn * cloth.mesh.rest).colwise() + Vec3(3, -2, 5);
    CHECK(blend.energy(x) < 1e-30);            // measured: 2e-32
    CHECK(force_at(blend, x).norm() < 1e-14);  // measured: 2e-16
    const Points bent = x + turn * random_points(3, 0.3, 1);
    const Points straight = cloth.mesh.rest + random_points(3, 0.3, 1);
    CHECK(blend.energy(bent) == Approx(blend.energy(straight)).epsilon(1e-12));
    CHECK((force_at(blend, bent) - turn * force_at(blend, straight)).norm() < 1e-13);
}

TEST_CASE("a triangle scaled as a whole strains the blend by its scale", "[force]") {
    const Cloth cloth = blended();
    const AltitudeBlend blend(cloth);
    for (const double scale : {0.01, 0.5, 0.9, 1.1, 3.0})
        CHECK(blend.energy(scale * cloth.mesh.rest) ==
              Approx(0.5 * weight_of(cloth) * (scale - 1) * (scale - 1)).epsilon(1e-12));
}

TEST_CASE("the blend follows the most compressed altitude, from above by at most 3^(1/8)", "[force]") {
    const Cloth cloth = blended();
    const AltitudeBlend blend(cloth);
    const auto heights = [](In x) { return altitudes_of(x.col(0), x.col(1), x.col(2)); };
    const Eigen::Vector3d rest = heights(cloth.mesh.rest);
    CHECK(weight_of(cloth) == Approx(rest.mean()));
    int compressed = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const Points x = cloth.mesh.rest + random_points(3, 0.4, seed);
        // s = D / (mean of (L_i h_i0)^8)^(1/8), from L_i = D / h_i
        const double doubled_area = Vec3(x.col(1) - x.col(0)).cross(Vec3(x.col(2) - x.col(0))).norm();
        const Eigen::Array3d rivals = doubled_area * rest.cwiseQuotient(heights(x)).array();
        const double s = doubled_area / std::pow(rivals.pow(8).mean(), 1.0 / 8);
        CHECK(blend.energy(x) == Approx(0.5 * weight_of(cloth) * (s - 1) * (s - 1)).epsilon(1e-9));
        const double least = heights(x).cwiseQuotient(rest).minCoeff();
        CHECK(s >= least);
        CHECK(s <= std::pow(3.0, 1.0 / 8) * least * (1 + 1e-12));
        compressed += s < 0.9;
    }
    CHECK(compressed > 20);
}

TEST_CASE("a collapsed triangle has no direction: the blend holds energy but pushes nowhere", "[force]") {
    const AltitudeBlend blend(blended(0.1));
    for (const Points& x : collapsed_triangles()) {
        CHECK(force_at(blend, x, random_points(3, 1, 1)).isZero(0));
        CHECK(blend.energy(x) == Approx(0.5 * weight_of(blended())));
        CHECK(std::isfinite(largest_bound(blend, x)));
    }
}

TEST_CASE("the blend's force changes steadily where that of the shortest altitude jumps", "[force]") {
    const auto largest_change = [](AltitudeMode mode) {
        const Cloth cloth = make_cloth(equilateral_triangle(), altitude_fabric(mode));
        const auto force = make_force("altitude springs", cloth);
        double largest = 0;
        Points last;
        // the apex runs along a line half way down, past the place where its altitude is no longer the least
        for (int i = 0; i <= 1000; ++i) {
            Points x = cloth.mesh.rest;
            x.col(1) = Vec3(1.5 * i / 1000.0, 0, 0.5 * x(2, 1));
            const Points f = force_at(*force, x);
            if (i > 0) largest = std::max(largest, (f - last).norm());
            last = f;
        }
        return largest;
    };
    CHECK(largest_change(AltitudeMode::blend) < 0.003);   // measured: 0.0014
    CHECK(largest_change(AltitudeMode::shortest) > 0.2);  // measured: 0.32
}

TEST_CASE("a blend with a damping ratio of one is critically damped", "[force]") {
    const Cloth cloth = blended(1);
    const AltitudeBlend blend(cloth);
    // the gradient of s at rest, from the energy 1/2 W (s - 1)^2 a little way along it
    const Points way = random_points(3, 1, 2);
    const Points gradient = force_at(blend, cloth.mesh.rest + 1e-7 * way).normalized();
    const Points inverse = gradient * cloth.mass.cwiseInverse().asDiagonal();
    const auto along = [&](const Points& f) { return f.cwiseProduct(inverse).sum(); };
    // y = gradient . displacement: y'' = -stiffness y - damping y'
    const double reach = gradient.squaredNorm();
    const double stiffness = -along(force_at(blend, cloth.mesh.rest + 1e-6 * gradient)) / (1e-6 * reach);
    const double damping = -along(force_at(blend, cloth.mesh.rest, gradient)) / reach;
    CHECK(damping * damping == Approx(4 * stiffness).epsilon(1e-5));  // measured: 1.7e-6, the step's
}

TEST_CASE("no pose of a triangle is stiffer than the blend's bound", "[force]") {
    double closest = 0;
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        Mesh mesh = equilateral_triangle();
        mesh.rest += random_points(3, 0.2, 1000 + seed);
        const AltitudeBlend blend(make_cloth(mesh, altitude_fabric(AltitudeMode::blend)));
        const Points x = mesh.rest + random_points(3, 0.01 * (seed % 50), seed);
        closest = std::max(closest, largest_stiffness(blend, x) / largest_bound(blend, x));
    }
    CAPTURE(closest);
    CHECK(closest < 1);    // measured: 0.97
    CHECK(closest > 0.5);  // else the bound would cost steps for nothing
}
