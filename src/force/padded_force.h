// A force whose sweeps work on padded vertices (base/padded.h): the equation of motion pads positions and
// velocities once for all of them.
#pragma once

#include "base/padded.h"
#include "force/force.h"

namespace drape {

class PaddedForce : public Force {
public:
    // As add_conservative and add_all; all have a column per vertex of the State. The second is asked of
    // forces that are not conservative alone.
    virtual void add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const = 0;
    virtual Power add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const = 0;

    void add_conservative(In x, Out f) const final;
    Power add_all(In x, In v, double time, Out f) const final;
    const PaddedForce* padded() const final { return this; }
};

}  // namespace drape
