// How far two pictures of one size are apart, in what an eye may see.
#pragma once

#include <functional>

#include "base/image.h"
#include "cloth/state.h"

namespace drape {

struct PictureError {
    double mean_levels = 0;  // mean absolute difference of 8-bit levels
    double share_over = 0;   // of pixels that differ by more than 8 levels in any channel
};

PictureError picture_error(const Image& picture, const Image& reference);

// Draws a state of the scene; empty where drape was built without its renderer.
using DrawState = std::function<Image(const State&)>;

}  // namespace drape
