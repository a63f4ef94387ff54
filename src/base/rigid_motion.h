// Rigid motion along keyframes: how an obstacle or a group of pins moves.
#pragma once

#include <cmath>
#include <vector>

#include "base/points.h"

namespace drape {

// x -> rotation x + translation. [translation] = m.
struct Pose {
    Mat3 rotation = Mat3::Identity();
    Vec3 translation = Vec3::Zero();

    Vec3 operator*(const Vec3& p) const { return rotation * p + translation; }
    Vec3 back(const Vec3& p) const { return rotation.transpose() * (p - translation); }
};

// Rotation about x, then y, then z, through fixed axes: R = Rz Ry Rx. Angles in degrees.
Mat3 rotation_from_degrees(const Vec3& degrees);

// The shortest turn that takes the y axis to a unit vector: with a = y x v and c = y . v it is
// c I + [a]x + a a^T / (1 + c). Straight down it is the half turn about x.
Mat3 rotation_from_up(const Vec3& unit);

// A pose and how fast it changes: the velocity of the point at p is linear + angular x (p -
// pose.translation).
struct MovingPose {
    Pose pose;
    Vec3 linear = Vec3::Zero();   // [m/s]
    Vec3 angular = Vec3::Zero();  // [rad/s]

    Vec3 velocity_at(const Vec3& p) const { return linear + angular.cross(p - pose.translation); }
};

struct Keyframe {
    double t = 0;                    // [s]
    Vec3 translate = Vec3::Zero();   // [m]
    Vec3 rotate_deg = Vec3::Zero();  // about x, then y, then z; may exceed 360 to say how many turns
};

// Keyframes joined by smooth curves: each of the six numbers runs along a monotone cubic (Fritsch-Carlson),
// so positions and velocities are continuous, nothing overshoots a keyframe and rest stays rest. Before the
// first key and after the last the pose stands still; no keys at all is the identity.
// Where the curve enters or leaves standstill at speed 0 the velocity has no jump either.
class RigidMotion {
public:
    RigidMotion() = default;
    // Rotations turn about the point `about`, which translations carry along. Times strictly increase, else
    // Error.
    explicit RigidMotion(std::vector<Keyframe> keys, const Vec3& about = Vec3::Zero());

    bool moves() const { return keys_.size() > 1; }
    const Vec3& about() const { return about_; }
    MovingPose at(double t) const;
    // no point within `radius` of the one that turns stay about is ever faster than this [m/s]
    double top_speed(double radius) const { return top_speed(radius, -INFINITY, INFINITY); }
    // the same from one time to another [s]
    double top_speed(double radius, double from, double to) const;
    double end_time() const { return keys_.empty() ? 0 : keys_.back().t; }

private:
    using Six = Eigen::Matrix<double, 6, 1>;
    std::vector<Keyframe> keys_;
    Vec3 about_ = Vec3::Zero();
    std::vector<Six> value_, slope_;
};

}  // namespace drape
