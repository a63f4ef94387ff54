// Integrators: ways to take the state from t to t + h. A new method is its file, its row in methods.cpp and
// its line in the README; the tests loop over the table and hold each to the order it states.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "integrate/dynamics.h"

namespace drape {

// What the system allows: no mode is faster than omega or more damped than gamma.
struct Spectrum {
    double omega = 0;  // [1/s]
    double gamma = 0;  // [1/s]
};

class Integrator {
public:
    virtual ~Integrator() = default;

    // Enters the method's own variables for steps of h. The state must be at its pins.
    virtual void begin(Dynamics& dynamics, State& state, double h) = 0;
    virtual void step(Dynamics& dynamics, State& state, double h) = 0;
    // Leaves them: the state is positions and velocities again.
    virtual void end(Dynamics& dynamics, State& state, double h) = 0;
};

struct Method {
    std::string_view name;
    std::string_view summary;
    int order;               // with conservative forces
    int order_with_damping;  // with damping, contact or anything else that depends on velocity or time
    int sweeps;              // force evaluations a step
    double (*longest_step)(const Spectrum&);  // that is stable for every mode within the spectrum [s]
    std::unique_ptr<Integrator> (*make)();
};

std::span<const Method> methods();

// Throws Error naming the nearest known method.
const Method& method_named(std::string_view name);

}  // namespace drape
