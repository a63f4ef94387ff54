// Integrators: ways to take the state from t to t + h. A new method is its file, its row in methods.cpp and
// its line in the README; the tests loop over the table and hold each to the order it states.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "integrate/dynamics.h"

namespace drape {

// What the system allows: no mode is faster than omega or more damped than gamma.
struct Spectrum {
    double omega = 0;  // [1/s]
    double gamma = 0;  // [1/s]
};

// What solving equations cost an implicit method, over all steps so far.
struct SolverWork {
    long factorisations = 0;
    long iterations = 0;  // of Newton's method, or local-global rounds
};

class Integrator {
public:
    virtual ~Integrator() = default;

    // Enters the method's own variables for steps of h. The state must be at its pins.
    virtual void begin(Dynamics& dynamics, State& state, double h) = 0;
    // False where an implicit method found no solution: the state is then of no use, and a shorter step from
    // the one before may succeed.
    [[nodiscard]] virtual bool step(Dynamics& dynamics, State& state, double h) = 0;
    // Leaves them: the state is positions and velocities again, which it always is for most methods.
    virtual void end(Dynamics&, State&, double) {}

    virtual SolverWork work() const { return {}; }
};

struct Method {
    std::string_view name;
    std::string_view summary;
    std::string_view limit;      // its stability limit, in words
    std::string_view conserves;  // what it keeps where the physics does
    std::string_view avoid;      // when not to use it
    int order;                   // with conservative forces
    int order_with_damping;      // with damping, contact or anything else that depends on velocity or time;
                                 // 0: the method is for scenes without
    int sweeps;                  // force evaluations a step; for implicit methods, an iteration
    // that is stable for every mode within the spectrum [s]; infinite if every step is
    double (*longest_step)(const Spectrum&);
    std::unique_ptr<Integrator> (*make)();
    bool controls_step = false;     // cuts a step that it finds too long, so that none is unstable
    bool projects_springs = false;  // so that only the other forces bind its step
    bool meets_itself = true;       // takes contact of cloth with cloth

    // Where force or its slope jumps (contact comes and goes, friction sticks and slips) no order above one
    // is left; elsewhere it is that of the forces.
    int order_where(bool conservative, bool jumps) const {
        const int smooth = conservative ? order : order_with_damping;
        return jumps ? std::min(smooth, 1) : smooth;
    }
    bool conservative_only() const { return order_with_damping == 0; }
    ForceShare explicit_share() const { return projects_springs ? ForceShare::unprojected : ForceShare::all; }
    bool is_implicit() const { return longest_step({1, 0}) == INFINITY; }
};

std::span<const Method> methods();

// Throws Error naming the nearest known method.
const Method& method_named(std::string_view name);

// The same for several, in that order; all there are where none is named.
std::vector<const Method*> methods_named(const std::vector<std::string>& names);

}  // namespace drape
