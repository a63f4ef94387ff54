// Symmetric splittings: a step made of kicks v += b_i h a(x) and drifts x += a_i h v in turn, beginning and
// ending with a kick. Each is symplectic and so is the whole; read backwards it is the same, so its order is
// even. From order four on some fractions are negative: time runs backwards in parts of the step, which
// damping, friction or contact cannot follow, so these methods are for conservative dynamics alone.
//
// For a mode x'' = -w^2 x a step is a matrix of determinant 1, stable while its trace is below 2 in size.
// Near h w = pi, 2 pi, ... the trace comes to 2 and passes it by little: a narrow band of h w in which modes
// grow slowly. The limits stated are where the first such band begins (tests/integrate/test_stability.cpp).
#pragma once

#include <memory>
#include <span>

#include "integrate/method.h"

namespace drape {

// `kicks` is one longer than `drifts`; both sum to 1. They must outlive the integrator.
struct Splitting {
    std::span<const double> kicks, drifts;  // b_i, a_i
};

std::unique_ptr<Integrator> make_splitting(const Splitting& splitting);

}  // namespace drape
