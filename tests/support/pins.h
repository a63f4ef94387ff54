// Holding vertices where they stand, or carrying them along.
#pragma once

#include "cloth/model.h"

namespace drape::test {

// Pins these columns of `x`; with a motion that turns, as one body about the origin.
void hold(Model& model, const std::vector<int>& vertices, In x, const RigidMotion& motion = {});

// A motion from rest at time `from` to rest at time `to`.
RigidMotion carry(double from, double to, const Vec3& translate, const Vec3& rotate_deg = Vec3::Zero());

}  // namespace drape::test
