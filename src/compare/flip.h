// What an eye notices when it flips between two pictures.
#pragma once

#include <vector>

#include "base/image.h"

namespace drape {

struct ErrorMap {
    int width = 0, height = 0;
    std::vector<float> error;  // 0 (none) to 1 for each pixel, row by row

    double mean() const;
};

// FLIP for pictures of 8 bits (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: A
// Difference Evaluator for Alternating Images, 2020), written anew from the formulas and constants that the
// authors' published program states (NVlabs/flip, python/flip_api.py). Both pictures are blurred as the eye
// blurs each opponent channel, and compared in a uniform colour space, c; edges and points that only one of
// them has, f, raise that to c^(1 - f). The eye sees 67 pixels in a degree: 0.7 m from a screen 0.7 m wide
// with 3840 pixels across. The pictures must be of one size.
ErrorMap flip(const Image& picture, const Image& reference);

}  // namespace drape
