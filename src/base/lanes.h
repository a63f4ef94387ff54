// Four doubles that the compiler works on side by side. In memory they need no more than a double's
// alignment: a plain 32-byte vector type is aligned to 16 where it is allocated for any machine, and the
// functions of wide.h that are compiled for wider vectors would rely on 32.
#pragma once

#include <cmath>

namespace drape {

typedef double Lanes __attribute__((vector_size(32), aligned(8)));

// Four doubles where they lie. A copy by memcpy would become two of half the width, through memory, in
// functions that are compiled for any machine and for wider vectors too.
typedef Lanes LanesInPlace __attribute__((may_alias));

inline __attribute__((always_inline)) void load(Lanes& value, const double* from) {
    value = *reinterpret_cast<const LanesInPlace*>(from);
}

inline __attribute__((always_inline)) void store(const Lanes& value, double* to) {
    *reinterpret_cast<LanesInPlace*>(to) = value;
}

inline __attribute__((always_inline)) Lanes square_root(Lanes value) {
    for (int k = 0; k < 4; ++k) value[k] = std::sqrt(value[k]);
    return value;
}

inline __attribute__((always_inline)) double square_root(double value) {
    return std::sqrt(value);
}

inline double lane_sum(const Lanes& value) {
    return (value[0] + value[1]) + (value[2] + value[3]);
}

}  // namespace drape
