// SRKN_6^b of S. Blanes and P. C. Moan, "Practical symplectic partitioned Runge-Kutta and Runge-Kutta-Nystrom
// methods", J. Comput. Appl. Math. 142 (2002): order four in six sweeps, its free coefficients chosen for a
// small error. Coefficients as the public source of Principia (integrators/methods.hpp) gives them; the order
// is checked by tests/integrate/test_order.cpp.
#include <array>

#include "integrate/kinds.h"
#include "integrate/splitting.h"

namespace drape {

namespace {

constexpr double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
constexpr double b4 = 1 - 2 * (b1 + b2 + b3);
constexpr double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);

constexpr std::array kicks{b1, b2, b3, b4, b3, b2, b1};
constexpr std::array drifts{a1, a2, a3, a3, a2, a1};

constexpr double first_band = 3.1634;  // h omega; splitting.h says what is there

}  // namespace

std::unique_ptr<Integrator> make_srkn4() {
    return make_splitting({kicks, drifts});
}

double srkn4_longest_step(const Spectrum& s) {
    return first_band / s.omega;
}

}  // namespace drape
