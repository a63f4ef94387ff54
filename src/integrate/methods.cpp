#include "integrate/method.h"

#include <array>

#include "base/names.h"
#include "integrate/kinds.h"

namespace drape {

namespace {

constexpr std::array table{
    Method{"symplectic_euler", "first order, one sweep; the game engine's choice, for comparison", 1, 1, 1,
           symplectic_euler_longest_step, make_symplectic_euler},
    Method{"verlet", "second order, one sweep, symplectic; the cheapest with damping or contact", 2, 2, 1,
           verlet_longest_step, make_verlet},
    Method{"takahashi_imada", "fourth order where energy is conserved (else second), two sweeps, symplectic",
           4, 2, 2, takahashi_imada_longest_step, make_takahashi_imada},
};

}  // namespace

std::span<const Method> methods() {
    return table;
}

const Method& method_named(std::string_view name) {
    return find_named(table, "method", name);
}

}  // namespace drape
