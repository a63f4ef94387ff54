// How jerkily cloth moves by the altitude springs it has: the power of its acceleration by frequency.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cloth/fabric.h"

namespace drape {

// The power of a signal sampled `rate` times a second, per hertz, at multiples of rate / length up to half
// the rate: Welch's method, Hann windows of `length` samples (a power of two) that overlap by half. Their sum
// times rate / length is the signal's mean square.
std::vector<double> power_density(std::span<const double> signal, int length, double rate);

struct Jitter {
    AltitudeMode mode = AltitudeMode::none;
    std::vector<double> density;  // of the acceleration, mean over vertices [m^2/s^4 per Hz]
    std::vector<double> trace;    // of one vertex: its acceleration, as sampled [m/s^2]
    double fastest = 0;           // frequency of the fastest mode at rest [Hz]
    double power = 0;             // mean square of the acceleration [m^2/s^4]

    double power_above(double frequency) const;  // the part at this frequency and beyond [m^2/s^4]
};

inline constexpr double jitter_rate = 2048;  // samples a second
inline constexpr int jitter_window = 256;    // samples

// A square of cloth falls from level, held at two corners, for `seconds`.
Jitter measure_jitter(AltitudeMode mode, double seconds);

}  // namespace drape
