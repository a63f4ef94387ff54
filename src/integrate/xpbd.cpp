// Extended position-based dynamics: small steps of symplectic Euler for every force but springs, then one
// sweep in which each spring in turn takes its own implicit Euler step (edge_projection.h); a membrane's
// triangles are springs here too (membrane_projection.h):
//   v += h a(x, v, t),   p = x + h v,   p <- sweep(p),   v = (p - x) / h,   x = p.
// One sweep with the multipliers started from 0 is order one in h: it is a product of the springs' separate
// implicit steps, which differs from the joint one by O(h^2). At coarse steps what is left over makes stiff
// cloth softer, most of all in its long waves, and implicit Euler damps it; both shrink with h. Many small
// steps of one sweep are better than few of many.
//
// The sweep goes through the colours in the same order every step: turned round every other step it loses the
// stiff swatch (33 x 33 vertices, 50000 N/m) at steps of 0.1 to 2 ms, where this stays near the truth. So do
// velocities by the second backward difference. Averaging over all springs at once (Jacobi) errs seven times
// more.
//
// Springs set no limit to the step; the other forces set that of symplectic Euler. What springs' damping and
// the implicit steps turn to heat is not booked.
#include <cmath>

#include "integrate/kinds.h"

namespace drape {

namespace {

class Xpbd final : public Integrator {
public:
    void begin(Dynamics& dynamics, State& state, double) override {
        x_.resize(4, state.x.cols());
        x_.row(3) = dynamics.model().inverse_mass.transpose();
        before_ = x_;
        dynamics.acceleration_to_kick(state.x, state.v, state.time, a_, ForceShare::unprojected);
    }
    bool step(Dynamics& dynamics, State& state, double h) override {
        dynamics.book(h);
        kick(dynamics, state, a_, h);
        predict(dynamics.model(), state, h);
        dynamics.project(x_, before_, h);
        finish(state, h);
        dynamics.acceleration_to_kick(state.x, state.v, state.time, a_, ForceShare::unprojected);
        return true;
    }

private:
    void predict(const Model& model, State& state, double h) {
        for (Eigen::Index i = 0; i < x_.cols(); ++i) {
            before_.col(i).head<3>() = state.x.col(i);
            x_.col(i).head<3>() = state.x.col(i) + h * state.v.col(i);
        }
        state.time += h;
        place_pins(model, state);
        for (const PinGroup& group : model.pins)
            for (const int i : group.vertices) x_.col(i).head<3>() = state.x.col(i);
    }
    void finish(State& state, double h) {
        const double rate = 1 / h;
        for (Eigen::Index i = 0; i < x_.cols(); ++i) {
            if (x_(3, i) == 0) continue;
            state.v.col(i) = rate * (x_.col(i) - before_.col(i)).head<3>();
            state.x.col(i) = x_.col(i).head<3>();
        }
    }

    WeightedPoints x_, before_;
    Points a_;
};

}  // namespace

std::unique_ptr<Integrator> make_xpbd() {
    return std::make_unique<Xpbd>();
}

double xpbd_longest_step(const Spectrum& s) {
    return symplectic_euler_longest_step(s);
}

}  // namespace drape
