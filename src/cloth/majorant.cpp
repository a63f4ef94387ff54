#include "cloth/majorant.h"

#include <algorithm>

#include "base/assert.h"

namespace drape {

void Majorant::add_entry(int i, int j, double value) {
    entries_.emplace_back(std::max(i, j), std::min(i, j), factor_ * value);
}

void Majorant::add_difference(int i, int j, double c) {
    add_entry(i, i, c);
    add_entry(j, j, c);
    add_entry(i, j, -c);
}

void Majorant::add_point(std::span<const int> vertices, std::span<const double> weights, double c) {
    DRAPE_ASSERT(vertices.size() == weights.size());
    for (size_t i = 0; i < vertices.size(); ++i)
        for (size_t j = 0; j <= i; ++j) add_entry(vertices[i], vertices[j], c * weights[i] * weights[j]);
}

}  // namespace drape
