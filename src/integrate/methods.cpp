#include "integrate/method.h"

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
           .avoid = "for long runs without damping, and where friction counts: that is of order two",
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
};

}  // namespace

std::span<const Method> methods() {
    return table;
}

const Method& method_named(std::string_view name) {
    return find_named(table, "method", name);
}

}  // namespace drape
