// The classical Runge-Kutta step of order four, for the methods that are made of it. With a_i the
// acceleration at stage i, taken at t, t + h/2, t + h/2, t + h with pins where they are then:
//   x += h v + h^2/6 (a1 + a2 + a3),   v += h/6 (a1 + 2 a2 + 2 a3 + a4)
// (the stages' velocities v, v + h/2 a1, v + h/2 a2, v + h a3 put into the usual formula). All forces are
// taken at the stage's own velocity, so damping, drag and moving pins keep the order at four.
//
// a5, at the end of the step, is the next step's a1. Put in place of a4 it gives an embedded formula of order
// three: with weights 1/6, 1/3, 1/3 and 1/6 the conditions up to that order ask of the last stage only that
// it stand at t + h and that its own weights sum to 1 with sum w_j c_j = 1/2, and those of a5, the step's
// weights, do as well as those of a4. The two differ by h/6 (a4 - a5): an estimate of the error that costs no
// sweep.
//
// Friction is one acceleration for the whole step: what its impulses would do to v + h a1, over h. Where that
// brings a vertex to rest its acceleration is 0 at every stage, so it sticks without creeping.
#pragma once

#include "integrate/method.h"

namespace drape {

class RungeKutta4 {
public:
    // the acceleration at the state
    void start(Dynamics& dynamics, const State& state);
    // Takes the state to t + h and the acceleration there. False if a stage lay inside an obstacle; the state
    // is then of no use.
    [[nodiscard]] bool advance(Dynamics& dynamics, State& state, double h);

    double disagreement() const;  // largest |a4 - a5| of any vertex in the last step [m/s^2]
    double largest() const;       // |a| of any vertex midway or at the end [m/s^2]

    // The step up to which every mode within the spectrum is stable.
    static double longest_step(const Spectrum& spectrum);

private:
    // acceleration at a trial of `seconds` from the state, its share of the step booked; false if it crossed
    bool stage(Dynamics& dynamics, const State& state, double seconds, Points& a, double booked);

    State trial_;
    Points first_, second_, third_, fourth_, ahead_, friction_;
};

}  // namespace drape
