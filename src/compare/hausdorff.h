// How far two sets of points are from covering each other, whichever point stands for which.
#pragma once

#include "base/points.h"

namespace drape {

// Hausdorff's distance [m]: the largest distance of a point of either set from the nearest of the other.
// Infinite where a coordinate is not finite, unless the sets are the same; 0 where both are empty.
double hausdorff_distance(const Points& points, const Points& reference);

}  // namespace drape
