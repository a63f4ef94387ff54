// Four doubles that the compiler works on side by side. In memory they need no more than a double's
// alignment: a plain 32-byte vector type is aligned to 16 where it is allocated for any machine, and the
// functions of wide.h that are compiled for wider vectors would rely on 32.
#pragma once

#include <cstring>

namespace drape {

typedef double Lanes __attribute__((vector_size(32), aligned(8)));

inline __attribute__((always_inline)) void load(Lanes& value, const double* from) {
    std::memcpy(&value, from, sizeof value);
}

inline __attribute__((always_inline)) void store(const Lanes& value, double* to) {
    std::memcpy(to, &value, sizeof value);
}

}  // namespace drape
