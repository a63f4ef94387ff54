#include "base/rigid_motion.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/error.h"

using namespace drape;

namespace {

const std::vector<Keyframe> walk{{0, {0, 0, 0}, {0, 0, 0}},
                                 {1, {1, 0.5, 0}, {30, 720, -20}},
                                 {1.5, {1.2, 0.5, -1}, {40, 700, 10}},
                                 {3, {4, 0.5, -1}, {90, 0, 80}}};

}  // namespace

TEST_CASE("rotations are about x, then y, then z", "[base]") {
    // y goes to z about x, then z to x about y, then x to y about z
    const Vec3 turned = rotation_from_degrees({90, 90, 90}) * Vec3::UnitY();
    CHECK((turned - Vec3::UnitY()).norm() < 1e-15);
    const Vec3 first = rotation_from_degrees({90, 90, 0}) * Vec3::UnitY();
    CHECK((first - Vec3::UnitX()).norm() < 1e-15);
}

TEST_CASE("a pose and its way back cancel", "[base]") {
    const Pose pose{rotation_from_degrees({10, -70, 200}), {1, 2, 3}};
    const Vec3 p(0.3, -4, 5);
    CHECK((pose.back(pose * p) - p).norm() < 1e-14);
}

TEST_CASE("a motion passes through its keyframes and stands still outside them", "[base]") {
    const RigidMotion motion(walk);
    for (const Keyframe& key : walk) {
        const Pose pose = motion.at(key.t).pose;
        CHECK((pose.translation - key.translate).norm() < 1e-12);
        CHECK((pose.rotation - rotation_from_degrees(key.rotate_deg)).norm() < 1e-12);
    }
    for (const double t : {-1.0, 0.0, 3.0, 9.0}) {
        CHECK(motion.at(t).linear == Vec3(0, 0, 0));
        CHECK(motion.at(t).angular == Vec3(0, 0, 0));
    }
    CHECK(motion.end_time() == 3);
}

TEST_CASE("a motion turns about the point it is given, which translations carry", "[base]") {
    const Vec3 about(0.3, -2, 1);
    const RigidMotion motion(walk, about);
    for (double t = 0; t < 3.1; t += 0.31) {
        const Pose pose = motion.at(t).pose, plain = RigidMotion(walk).at(t).pose;
        CHECK((pose * about - (about + plain.translation)).norm() < 1e-12);
        CHECK(pose.rotation == plain.rotation);
    }
    const std::vector<Keyframe> straight{{0, {0, 0, 0}}, {1, {0.1, 0.7, 0}}};
    CHECK(RigidMotion(straight, about).at(0.3).pose.translation ==
          RigidMotion(straight).at(0.3).pose.translation);
}

TEST_CASE("the velocity a motion tells is the rate at which its points move", "[base]") {
    const RigidMotion motion(walk, GENERATE(Vec3(0, 0, 0), Vec3(0.1, 2, -0.4)));
    const Vec3 local(0.2, -0.4, 0.7);
    constexpr double h = 1e-5;
    for (double t = 0.05; t < 3; t += 0.0937) {
        const MovingPose now = motion.at(t);
        const Vec3 rate = (motion.at(t + h).pose * local - motion.at(t - h).pose * local) / (2 * h);
        CAPTURE(t);
        CHECK((now.velocity_at(now.pose * local) - rate).norm() < 1e-4);  // measured 2e-6
    }
}

TEST_CASE("a motion never overshoots its keyframes and never exceeds its top speed", "[base]") {
    const RigidMotion motion(walk);
    constexpr double radius = 0.8;
    const double top = motion.top_speed(radius);
    double fastest = 0;
    for (double t = 0; t <= 3; t += 0.003) {
        const MovingPose now = motion.at(t);
        CHECK(now.pose.translation.x() <= 4 + 1e-12);
        CHECK(now.pose.translation.y() <= 0.5 + 1e-12);
        CHECK(now.pose.translation.z() >= -1 - 1e-12);
        fastest = std::max(fastest, now.linear.norm() + radius * now.angular.norm());
    }
    CHECK(fastest <= top);
    CHECK(fastest > top / 6);  // the bound is a bound, not infinity
}

TEST_CASE("a motion's top speed between two times is that of the keyframes around them", "[base]") {
    const RigidMotion motion({{0, Vec3::Zero()}, {1, Vec3(1, 0, 0)}, {2, Vec3(1, 0, 0)}, {3, Vec3(1, 9, 0)}});
    CHECK(motion.top_speed(0, 0.4, 0.6) == Approx(3));
    CHECK(motion.top_speed(0, 1, 2) == 0);
    CHECK(motion.top_speed(0, 0.9, 2) == Approx(3));
    CHECK(motion.top_speed(0, 1.5, 2.5) == Approx(27));
    CHECK(motion.top_speed(0, 3, 4) == 0);
    CHECK(motion.top_speed(0) == Approx(27));
}

TEST_CASE("no keyframes is no motion, and times that do not increase are refused", "[base]") {
    const RigidMotion still;
    CHECK_FALSE(still.moves());
    CHECK(still.at(5).pose * Vec3(1, 2, 3) == Vec3(1, 2, 3));
    CHECK(still.top_speed(1) == 0);
    Keyframe one, same, never;
    one.t = same.t = 1;
    never.t = std::nan("");
    CHECK_THROWS_AS(RigidMotion({one, same}), Error);
    CHECK_THROWS_AS(RigidMotion({one, never}), Error);
}

TEST_CASE("the turn from up is a shortest rotation that takes y to the direction", "[base]") {
    for (const Vec3& way : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0.3, -0.7, 0.2),
                            Vec3(1e-5, -1, 0), Vec3(-0.4, 0.1, -2)}) {
        const Vec3 unit = way.normalized();
        const Mat3 turn = rotation_from_up(unit);
        CHECK((turn * Vec3::UnitY() - unit).norm() < 1e-15);
        CHECK((turn.transpose() * turn - Mat3::Identity()).norm() < 1e-14);
        CHECK(turn.determinant() == Approx(1));
        // the trace of a turn by an angle is 1 + 2 cos; no turn that gets there has a smaller angle
        CHECK(turn.trace() == Approx(1 + 2 * unit.y()).margin(1e-14));
    }
}
