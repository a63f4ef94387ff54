// Pictures put beside each other, and what their pixels differ in.
#pragma once

#include <span>

#include "base/image.h"

namespace drape {

// The pictures, of one size, from left to right in rows of `columns`, with a dark line between them.
Image beside(std::span<const Image> pictures, int columns);

// `gain` times what two pictures of one size are apart in each channel, clamped: black where they are alike.
Image amplified_difference(const Image& picture, const Image& reference, int gain);

// At least `width` x `height`, the last column and row repeated.
Image extended(const Image& image, int width, int height);

}  // namespace drape
