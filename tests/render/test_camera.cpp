#include "render/camera.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "render/renderer.h"

using namespace drape;

TEST_CASE("the automatic camera sees every corner of the bounds, and wastes little of the picture",
          "[render]") {
    const double aspect = GENERATE(16.0 / 9, 1.0, 0.6);
    const Vec3 size = GENERATE(Vec3(1, 1, 1), Vec3(3, 0.01, 1), Vec3(0.02, 2, 0.5), Vec3(1e-3, 1e-3, 1e-3));
    const Vec3 low(0.3, -2, 5);
    const Eigen::AlignedBox3d bounds(low, Vec3(low + size));
    const View view(frame_automatically(bounds, aspect), aspect);
    Points corners(3, 8);
    for (int i = 0; i < 8; ++i)
        corners.col(i) = bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    Eigen::AlignedBox2d seen;
    view.project(corners, seen);
    CHECK(seen.min().minCoeff() > -1);
    CHECK(seen.max().maxCoeff() < 1);
    CHECK(seen.sizes().maxCoeff() > 1.2);
    CHECK(view.eye.y() > bounds.center().y());
}

TEST_CASE("a sphere beside the picture is missed, one that reaches into it is not", "[render]") {
    const View view({Vec3(0, 0, 5), Vec3(0, 0, 0), 40}, 1.0);
    CHECK(view.misses(Vec3(4, 0, 0), 1));
    CHECK_FALSE(view.misses(Vec3(2.5, 0, 0), 1));
    CHECK(view.misses(Vec3(0, 0, 8), 1));
    CHECK_FALSE(view.misses(Vec3(0, 0, -50), 1));
}

TEST_CASE("a camera that looks at itself or has no angle is an error", "[render]") {
    CHECK_THROWS_AS(View({Vec3(1, 1, 1), Vec3(1, 1, 1), 24}, 1.0), Error);
    CHECK_THROWS_AS(View({Vec3(1, 1, 1), Vec3(0, 0, 0), 0}, 1.0), Error);
}
