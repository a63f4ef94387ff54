#include "support/pins.h"

namespace drape::test {

void hold(Model& model, const std::vector<int>& vertices, In x, const RigidMotion& motion) {
    PinGroup group;
    group.vertices = vertices;
    group.anchors = x(Eigen::all, vertices);
    group.motion = motion;
    group.rigid = true;
    add_pins(model, std::move(group));
}

RigidMotion carry(double from, double to, const Vec3& translate, const Vec3& rotate_deg) {
    Keyframe first, last;
    first.t = from;
    last.t = to;
    last.translate = translate;
    last.rotate_deg = rotate_deg;
    return RigidMotion({first, last});
}

}  // namespace drape::test
