// The makers of every pattern, for the table in pattern.cpp.
#pragma once

#include "mesh/pattern.h"

namespace drape {

Mesh make_one_way(const PatternSize& size);
Mesh make_alternating(const PatternSize& size);
Mesh make_crossed(const PatternSize& size);
Mesh make_equilateral(const PatternSize& size);
Mesh make_pseudo_random(const PatternSize& size);
Mesh make_adaptive(const PatternSize& size);

SizeField even_edges(const PatternSize& size, const Eigen::Vector2d& low, const Eigen::Vector2d& high);
SizeField adaptive_edges(const PatternSize& size, const Eigen::Vector2d& low, const Eigen::Vector2d& high);

}  // namespace drape
