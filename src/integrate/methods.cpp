#include "integrate/method.h"

#include <algorithm>
#include <array>

#include "base/names.h"
#include "integrate/kinds.h"

namespace drape {

namespace {

constexpr std::array table{
    Method{.name = "symplectic_euler",
           .summary = "one kick, one drift: first order; the game engine's choice, for comparison",
           .limit = "h omega <= 2 less damping",
           .conserves = "symplectic: energy swings by order h and does not drift; momenta",
           .avoid = "whenever accuracy counts: Verlet costs the same",
           .order = 1,
           .order_with_damping = 1,
           .sweeps = 1,
           .longest_step = symplectic_euler_longest_step,
           .make = make_symplectic_euler},
    Method{.name = "verlet",
           .summary = "kick, drift, kick: second order, one sweep; the cheapest with damping or contact",
           .limit = "h omega <= 2 less damping",
           .conserves = "symplectic: energy swings by order h^2 and does not drift; momenta",
           .avoid = "for tight tolerances, and where stiffness asks for far shorter steps than motion does",
           .order = 2,
           .order_with_damping = 2,
           .sweeps = 1,
           .longest_step = verlet_longest_step,
           .make = make_verlet},
    Method{.name = "takahashi_imada",
           .summary = "Verlet at shifted positions, processed: fourth order where energy is conserved",
           .limit = "h omega <= 2 sqrt 3; with damping h gamma <= 1/4",
           .conserves = "symplectic: energy swings by order h^4 and does not drift; momenta",
           .avoid = "with damping or contact: it is then of order two at twice Verlet's cost",
           .order = 4,
           .order_with_damping = 2,
           .sweeps = 2,
           .longest_step = takahashi_imada_longest_step,
           .make = make_takahashi_imada},
    Method{.name = "srkn4",
           .summary = "Blanes and Moan's six kicks and drifts: fourth order with a small error",
           .limit = "h omega <= 3.163; slow growth in a narrow band above",
           .conserves = "symplectic: energy swings by order h^4 and does not drift; momenta",
           .avoid = "where Takahashi-Imada's error is small enough: three times its sweeps at the limit",
           .order = 4,
           .order_with_damping = 0,
           .sweeps = 6,
           .longest_step = srkn4_longest_step,
           .make = make_srkn4},
    Method{.name = "srkn6",
           .summary = "Blanes and Moan's eleven kicks and drifts: sixth order, for tight tolerances",
           .limit = "h omega <= 3.141; slow growth in a narrow band above",
           .conserves = "symplectic: energy swings by order h^6 and does not drift; momenta",
           .avoid = "for tolerances that a method of order four meets at its limit",
           .order = 6,
           .order_with_damping = 0,
           .sweeps = 11,
           .longest_step = srkn6_longest_step,
           .make = make_srkn6},
    Method{.name = "rk4",
           .summary = "classical Runge-Kutta: fourth order with every smooth force",
           .limit = "h omega <= 2.828; with damping h max(omega, gamma) <= 2.615",
           .conserves = "nothing: energy is lost by order h^5, fast modes' near the limit at once",
           .avoid = "for long runs without damping, and where friction counts: that is of order one",
           .order = 4,
           .order_with_damping = 4,
           .sweeps = 4,
           .longest_step = rk4_longest_step,
           .make = make_rk4},
    Method{.name = "embedded_rk",
           .summary = "classical Runge-Kutta that cuts steps where its free error estimate asks for it",
           .limit = "none: what would grow is cut; uncut up to rk4's limit",
           .conserves = "nothing: energy is lost by order h^5",
           .avoid = "for long runs without damping: a symplectic method errs less at the same cost",
           .order = 4,
           .order_with_damping = 4,
           .sweeps = 4,
           .longest_step = embedded_rk_longest_step,
           .make = make_embedded_rk,
           .controls_step = true},
    Method{
        .name = "xpbd",
        .summary = "one sweep of spring projections a small step: cheapest for stiff cloth to a centimetre",
        .limit =
            "none from springs, but stiff ones may gain energy from 0.1 ms; else h omega <= 2 less damping",
        .conserves = "linear momentum; springs lose energy by order h, fast modes at once",
        .avoid = "where millimetres or energy count, and on soft cloth",
        .order = 1,
        .order_with_damping = 1,
        .sweeps = 1,
        .longest_step = xpbd_longest_step,
        .make = make_xpbd,
        .projects_springs = true,
        .meets_itself = false},
    Method{.name = "backward_euler_1",
           .summary = "linearised backward Euler (Baraff-Witkin): one solve a step; for comparison",
           .limit = "none for small motion; large steps may leave forces out of balance",
           .conserves = "nothing: it damps motion by (h omega)^2 / 2 of its energy a step",
           .avoid = "whenever accuracy counts; where cloth folds in one step; with fast obstacles",
           .order = 1,
           .order_with_damping = 1,
           .sweeps = 2,
           .longest_step = unlimited_step,
           .make = make_backward_euler_1},
    Method{.name = "backward_euler",
           .summary = "backward Euler solved by Newton's method with line search: the most robust",
           .limit = "none: every step goes to a minimum of inertia and energy",
           .conserves = "never gains energy; damps motion by (h omega)^2 / 2 of its energy a step",
           .avoid = "whenever accuracy counts: BDF2 costs the same",
           .order = 1,
           .order_with_damping = 1,
           .sweeps = 2,
           .longest_step = unlimited_step,
           .make = make_backward_euler},
    Method{.name = "bdf2",
           .summary = "two steps back: second order at one solve a step",
           .limit = "none for small motion (L-stable); from 5 ms stiff springs may gain energy",
           .conserves = "nothing: it damps motion by order h^4 of its energy a step",
           .avoid = "where steps change often: each frame starts with a step of TR-BDF2",
           .order = 2,
           .order_with_damping = 2,
           .sweeps = 2,
           .longest_step = unlimited_step,
           .make = make_bdf2},
    Method{.name = "tr_bdf2",
           .summary = "trapezoid, then BDF2, within a step: second order for very stiff cloth",
           .limit = "none for small motion (L-stable); from 10 ms stiff springs may gain energy",
           .conserves = "nothing: it damps motion by order h^4 of its energy a step",
           .avoid = "where an explicit step is affordable: two solves a step",
           .order = 2,
           .order_with_damping = 2,
           .sweeps = 4,
           .longest_step = unlimited_step,
           .make = make_tr_bdf2},
    Method{.name = "projective_dynamics",
           .summary = "backward Euler by rounds with one constant matrix: long steps of soft cloth",
           .limit = "none: what a thousand rounds do not solve is tried again at half the step",
           .conserves = "as backward Euler, but for what its rounds leave unsolved: some thousandths",
           .avoid = "whenever accuracy counts; with stiff springs: rounds grow with h omega",
           .order = 1,
           .order_with_damping = 1,
           .sweeps = 2,
           .longest_step = unlimited_step,
           .make = make_projective_dynamics,
           .meets_itself = false},
};

}  // namespace

std::span<const Method> methods() {
    return table;
}

const Method& method_named(std::string_view name) {
    return find_named(table, "method", name);
}

std::vector<const Method*> methods_named(const std::vector<std::string>& names) {
    std::vector<const Method*> named;
    for (const std::string& name : names)
        if (const Method* method = &method_named(name);
            std::find(named.begin(), named.end(), method) == named.end())
            named.push_back(method);
    if (names.empty())
        for (const Method& method : table) named.push_back(&method);
    return named;
}

}  // namespace drape
