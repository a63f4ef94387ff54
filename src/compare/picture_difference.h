// How far two pictures of one size are apart, in what an eye may see.
#pragma once

#include "base/image.h"

namespace drape {

struct PictureDifference {
    double mean_levels = 0;  // mean absolute difference of 8-bit levels
    double share_over = 0;   // of pixels that differ by more than 8 levels in any channel
};

// The pictures must be of one size.
PictureDifference picture_difference(const Image& picture, const Image& reference);

}  // namespace drape
