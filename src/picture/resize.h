// A picture at another size.
#pragma once

#include "base/image.h"

namespace drape {

// Resampled in linear light, so that what is fine keeps its brightness (Mitchell and Netravali's filter where
// it becomes smaller).
Image resized(const Image& image, int width, int height);

}  // namespace drape
