// Something to integrate: the linear oscillator, and a cloth with every force of its scene.
#pragma once

#include "integrate/method.h"
#include "support/cloths.h"
#include "support/pins.h"

namespace drape::test {

// A vertex of 1 kg on a spring of rest length 0 to a pin at the origin: x'' = -omega^2 x - gamma x' along x.
class Oscillator {
public:
    explicit Oscillator(const Spectrum& mode, double rest_length = 0);

    Dynamics& dynamics() { return dynamics_; }
    static State at(const Vec3& x, const Vec3& v);
    double energy(const State& state) const;

private:
    Model model_;
    Dynamics dynamics_;
};

std::vector<ActiveForce> forces_of(const Model& model, const Surroundings& world);

// Where `steps` equal steps take the state by `end`.
State integrated(const Method& method, Dynamics& dynamics, State state, double end, int steps);

}  // namespace drape::test
