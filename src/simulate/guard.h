// Watches that a run stays finite and takes no energy from nowhere, which is how every instability shows.
#pragma once

#include <optional>

#include "integrate/dynamics.h"

namespace drape {

// What a method accounts for.
struct Books {
    bool drive = true;    // what moving pins put in; without that there is no balance to draw
    bool springs = true;  // forces of springs: sweeps of projections leave stiff ones stretched, and that
                          // energy is never set free
};

class Guard {
public:
    // `gravity` [m/s^2].
    Guard(const Dynamics& dynamics, const Vec3& gravity, Books books);

    // Takes stock before a frame of `duration` [s]. `known`: this is the very state that gain() was last
    // asked about, whose energies need no sum.
    void begin_frame(const State& state, double duration, bool known = false);

    // After a step: velocities are finite and hold no more kinetic energy than what was there at the frame's
    // start, what gravity could add in a frame and what was put in since. One sum over the vertices.
    bool step_holds(In v) const;

    // After the frame: what kinetic, elastic, gravitational and contact energy gained, less what wind, pins
    // and obstacles put in, plus what damping and friction took, over the energies at play. Above most_gain
    // the frame does not hold.
    double gain(const State& state);

    static constexpr double most_gain = 0.1;

private:
    struct Stock {
        double kinetic = 0, potential = 0, weight = 0;  // [J]
    };
    Stock stock_of(const State& state) const;
    double kinetic_energy(In v) const;
    double weight_energy(In x) const;  // gravitational [J]

    const Dynamics& dynamics_;
    Vec3 gravity_;
    Books books_;
    Eigen::VectorXd half_mass_;  // of every coordinate, 0 where pinned [kg]
    double mass_ = 0;            // free [kg]
    Stock start_;                // of the frame
    std::optional<Stock> last_;  // where gain() was asked
    double available_ = 0;       // to become kinetic in a frame [J]
    EnergyFlow flow_;
};

}  // namespace drape
