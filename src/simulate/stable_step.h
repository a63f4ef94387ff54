// The longest step that is safe, and by how much.
#pragma once

#include "integrate/dynamics.h"
#include "integrate/method.h"

namespace drape {

// Gershgorin: no mode is faster than sqrt(max_i rows_i / m_i), whatever the shape of the mode.
Spectrum gershgorin_spectrum(const Dynamics& dynamics, In x, ForceShare share = ForceShare::all);

// How fast the fastest mode is at the pose x without contact, by Lanczos iteration on the stiffness from a
// fixed start [1/s]. It approaches the true value from below, and depends on nothing but the pose.
double measured_omega(Dynamics& dynamics, In x, ForceShare share = ForceShare::all);

// How strong the strongest damping of a mode is without contact, likewise [1/s]: what is linear in velocity
// measured, and Gershgorin's bound on the rest (wind), which would be to ask for every flow there may be.
double measured_gamma(Dynamics& dynamics, In x, ForceShare share = ForceShare::all);

// The spectrum with contact's share added: eigenvalues of a sum are at most the sum of the largest.
Spectrum with_contact(const Spectrum& spectrum, const ContactLimits& limits);

}  // namespace drape
