// The longest step that is safe, and by how much.
#pragma once

#include "integrate/dynamics.h"
#include "integrate/method.h"

namespace drape {

// Gershgorin: no mode is faster than sqrt(max_i rows_i / m_i), whatever the shape of the mode.
Spectrum gershgorin_spectrum(const Dynamics& dynamics, In x);

// The fastest mode by power iteration on the stiffness at the pose x, starting from `mode` and leaving the
// last estimate there [1/s]. It approaches the true value from below.
double measured_omega(Dynamics& dynamics, In x, double time, Points& mode, int iterations);

// The spectrum with contact's share added: eigenvalues of a sum are at most the sum of the largest.
Spectrum with_contact(const Spectrum& spectrum, const ContactLimits& limits);

}  // namespace drape
