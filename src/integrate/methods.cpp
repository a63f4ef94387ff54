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
};

}  // namespace

std::span<const Method> methods() {
    return table;
}

const Method& method_named(std::string_view name) {
    return find_named(table, "method", name);
}

}  // namespace drape
