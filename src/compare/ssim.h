// Structural similarity: how alike two pictures are in local brightness, contrast and pattern.
#pragma once

#include "base/image.h"

namespace drape {

// The mean over all pixels of
//   (2 mx my + C1) (2 sxy + C2) / ((mx^2 + my^2 + C1) (sx^2 + sy^2 + C2)),  C1 = (0.01 255)^2, C2 = (0.03
//   255)^2
// with means, variances and covariance of the grey levels 0.299 R + 0.587 G + 0.114 B weighed by a Gaussian
// of sigma 1.5 pixels, cut to 11 x 11; the border's pixels are repeated outwards. 1 where the pictures are
// the same, less where they are not, down to -1. Formula and constants (Wang, Bovik, Sheikh, Simoncelli 2004)
// as scikit-image's structural_similarity states them. The pictures must be of one size.
double ssim(const Image& picture, const Image& reference);

}  // namespace drape
