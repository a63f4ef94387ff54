// How far the positions of two caches are apart, sample by sample.
#pragma once

#include <optional>
#include <vector>

#include "io/cache_reader.h"

namespace drape {

// Of the sample where two caches are furthest apart (root mean square over vertices).
struct CacheDifference {
    int sample = 0;                  // 0 is the start, k frame k
    double rms_m = 0;                // [m]
    double most_m = 0;               // of the vertex furthest away, in any sample [m]
    int vertex = 0;                  // that vertex
    int from = -1;                   // the first sample that is not the same to the last bit; -1: all are
    std::vector<double> rms_each{};  // of every sample [m]
    std::optional<double>
        hausdorff_m{};  // the largest of any sample (hausdorff.h), where it is asked for [m]
};

// The caches must have the same number of vertices; samples that only one has are not looked at. A position
// that is not a number is infinitely far from all but the same.
CacheDifference cache_difference(const Cache& cache, const Cache& reference);

// The largest of hausdorff.h over the samples that both have; vertices need not be as many [m].
double largest_hausdorff(const Cache& cache, const Cache& reference);

}  // namespace drape
