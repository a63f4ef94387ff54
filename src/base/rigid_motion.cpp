#include "base/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace drape {

namespace {

constexpr double radians = std::numbers::pi / 180;

}  // namespace

Mat3 rotation_from_degrees(const Vec3& degrees) {
    const auto turn = [&](int axis) {
        return Eigen::AngleAxisd(degrees[axis] * radians, Vec3::Unit(axis)).toRotationMatrix();
    };
    return turn(2) * turn(1) * turn(0);
}

Mat3 rotation_from_up(const Vec3& unit) {
    const double c = unit.y(), p = unit.x(), q = unit.z();  // a = (q, 0, -p)
    const double aside = p * p + q * q;                     // (1 - c) (1 + c), exact where 1 + c is not
    if (c < 0 && aside == 0) return Vec3(1, -1, -1).asDiagonal();
    const double share = c < 0 ? (1 - c) / aside : 1 / (1 + c);
    Mat3 turn;
    turn << 1 - share * p * p, p, -share * p * q, -p, c, -q, -share * p * q, q, 1 - share * q * q;
    return turn;
}

RigidMotion::RigidMotion(std::vector<Keyframe> keys, const Vec3& about)
    : keys_(std::move(keys)), about_(about) {
    for (size_t i = 1; i < keys_.size(); ++i)
        if (!(keys_[i].t > keys_[i - 1].t))
            throw Error(cat("keyframe times must increase, got ", keys_[i - 1].t, " then ", keys_[i].t));
    for (const Keyframe& key : keys_) {
        Six six;
        six << key.translate, key.rotate_deg;
        value_.push_back(six);
    }
    // Fritsch-Carlson slopes: zero at a turning point, else the harmonic mean of the two secants
    slope_.assign(keys_.size(), Six::Zero());
    for (size_t i = 1; i + 1 < keys_.size(); ++i) {
        const double left = keys_[i].t - keys_[i - 1].t, right = keys_[i + 1].t - keys_[i].t;
        for (int c = 0; c < 6; ++c) {
            const double before = (value_[i][c] - value_[i - 1][c]) / left;
            const double after = (value_[i + 1][c] - value_[i][c]) / right;
            if (before * after <= 0) continue;
            const double w1 = 2 * right + left, w2 = right + 2 * left;
            slope_[i][c] = (w1 + w2) / (w1 / before + w2 / after);
        }
    }
}

MovingPose RigidMotion::at(double t) const {
    MovingPose moving;
    if (keys_.empty()) return moving;
    Six value = value_.front(), rate = Six::Zero();
    if (t >= keys_.back().t) {
        value = value_.back();
    } else if (t > keys_.front().t) {
        const auto after = std::upper_bound(keys_.begin(), keys_.end(), t,
                                            [](double time, const Keyframe& key) { return time < key.t; });
        const auto i = static_cast<size_t>(after - keys_.begin()) - 1;
        // cubic Hermite on [keys_[i].t, keys_[i + 1].t]
        const double h = keys_[i + 1].t - keys_[i].t, s = (t - keys_[i].t) / h;
        const Six a = value_[i], b = value_[i + 1], da = h * slope_[i], db = h * slope_[i + 1];
        value = (2 * s * s * s - 3 * s * s + 1) * a + (s * s * s - 2 * s * s + s) * da +
                (-2 * s * s * s + 3 * s * s) * b + (s * s * s - s * s) * db;
        rate = ((6 * s * s - 6 * s) * (a - b) + (3 * s * s - 4 * s + 1) * da + (3 * s * s - 2 * s) * db) / h;
    }
    const Vec3 degrees = value.tail<3>(), turning = rate.tail<3>() * radians;
    const Mat3 rotation = rotation_from_degrees(degrees);
    const Vec3 about_turned = rotation * about_;
    // where nothing turns the bracket is exactly zero
    moving.pose = {rotation, value.head<3>() + (about_ - about_turned)};
    // R = Rz Ry Rx: angular velocity is the z rate, plus the y rate carried by Rz, plus the x rate by Rz Ry
    const Mat3 rz = rotation_from_degrees({0, 0, degrees.z()});
    const Mat3 rzy = rotation_from_degrees({0, degrees.y(), degrees.z()});
    moving.angular = turning.z() * Vec3::UnitZ() + rz * (turning.y() * Vec3::UnitY()) +
                     rzy * (turning.x() * Vec3::UnitX());
    moving.linear = rate.head<3>() - moving.angular.cross(about_turned);
    return moving;
}

double RigidMotion::top_speed(double radius, double from, double to) const {
    double fastest = 0;
    for (size_t i = 1; i < keys_.size(); ++i) {
        if (keys_[i].t <= from || keys_[i - 1].t >= to) continue;
        // a monotone cubic is never steeper than three times its secant
        const double h = keys_[i].t - keys_[i - 1].t;
        const Six secant = (value_[i] - value_[i - 1]) / h;
        const double linear = 3 * secant.head<3>().norm();
        const double angular = 3 * secant.tail<3>().lpNorm<1>() * radians;
        fastest = std::max(fastest, linear + angular * radius);
    }
    return fastest;
}

}  // namespace drape
