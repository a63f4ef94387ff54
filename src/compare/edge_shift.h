// Tells an edge that moved by less than a pixel, as antialiasing shows it, from another colour.
#pragma once

#include "base/image.h"

namespace drape {

// Whether the pictures' difference at a pixel may come of an edge that moved by up to one pixel: each
// picture's colour there is one that the other has within its 3 x 3 pixels around it, in every channel from
// the darkest of them to the brightest, with `slack` levels to either side. A spot on a plain ground is not
// explained, nor is a line that went away, nor a shade that changed.
bool explained_by_shift(const Image& picture, const Image& reference, int x, int y, int slack);

}  // namespace drape
