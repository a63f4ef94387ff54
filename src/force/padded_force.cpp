#include "force/padded_force.h"

namespace drape {

void PaddedForce::add_conservative(In x, Out f) const {
    PaddedPoints at, sum = PaddedPoints::Zero(4, x.cols());
    pad(x, at);
    add_padded_conservative(at, sum);
    f += sum.topRows<3>();
}

Power PaddedForce::add_all(In x, In v, double, Out f) const {
    if (is_conservative()) {
        add_conservative(x, f);
        return {};
    }
    PaddedPoints at, moving, sum = PaddedPoints::Zero(4, x.cols());
    pad(x, at);
    pad(v, moving);
    const Power power = add_padded(at, moving, sum);
    f += sum.topRows<3>();
    return power;
}

}  // namespace drape
