// SRKN_11^b of S. Blanes and P. C. Moan, "Practical symplectic partitioned Runge-Kutta and
// Runge-Kutta-Nystrom methods", J. Comput. Appl. Math. 142 (2002): order six in eleven sweeps. Their
// SRKN_14^a has a smaller error but the same limit, 3.1409, at three sweeps more, and cloth's step is set by
// the limit. Coefficients as the public source of Principia (integrators/methods.hpp) gives them; the order
// is checked by tests/integrate/test_order.cpp.
#include <array>

#include "integrate/kinds.h"
#include "integrate/splitting.h"

namespace drape {

namespace {

constexpr double b1 = 0.0414649985182624, b2 = 0.198128671918067, b3 = -0.0400061921041533,
                 b4 = 0.0752539843015807, b5 = -0.0115113874206879, b6 = 0.5 - (b1 + b2 + b3 + b4 + b5);
constexpr double a1 = 0.123229775946271, a2 = 0.290553797799558, a3 = -0.127049212625417,
                 a4 = -0.246331761062075, a5 = 0.357208872795928, a6 = 1 - 2 * (a1 + a2 + a3 + a4 + a5);

constexpr std::array kicks{b1, b2, b3, b4, b5, b6, b6, b5, b4, b3, b2, b1};
constexpr std::array drifts{a1, a2, a3, a4, a5, a6, a5, a4, a3, a2, a1};

constexpr double first_band = 3.1414;  // h omega; splitting.h says what is there

}  // namespace

std::unique_ptr<Integrator> make_srkn6() {
    return make_splitting({kicks, drifts});
}

double srkn6_longest_step(const Spectrum& s) {
    return first_band / s.omega;
}

}  // namespace drape
