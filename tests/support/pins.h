// Holding vertices where they stand, or carrying them along.
#pragma once

#include "cloth/model.h"

namespace drape::test {

// Pins these columns of `x`; with a motion that turns, as one body about the origin.
inline void hold(Model& model, const std::vector<int>& vertices, In x, const RigidMotion& motion = {}) {
    PinGroup group;
    group.vertices = vertices;
    group.anchors = x(Eigen::all, vertices);
    group.motion = motion;
    group.rigid = true;
    add_pins(model, std::move(group));
}

// A motion from rest at time `from` to rest at time `to`.
inline RigidMotion carry(double from, double to, const Vec3& translate,
                         const Vec3& rotate_deg = Vec3::Zero()) {
    Keyframe first, last;
    first.t = from;
    last.t = to;
    last.translate = translate;
    last.rotate_deg = rotate_deg;
    return RigidMotion({first, last});
}

}  // namespace drape::test
