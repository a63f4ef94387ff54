// Edges of all cloths, as what takes neighbours along where vertices are moved by hand.
#pragma once

#include <array>
#include <vector>

#include "cloth/model.h"

namespace drape {

class Neighbours {
public:
    // Lengths are those at x.
    Neighbours(const Model& model, In x);

    // Edges that start at the vertex are no longer than at rest from now on: what is stretched because
    // something else is in its way need not stay so.
    void relax(int vertex);

    // Lets neighbours take part in a move, [move] = 3 x V; what is pinned stays. Single moves spread over
    // some edges and get smaller.
    void smooth(Points& move) const;

    // Moves the ends of edges towards the length that they had, a few times in turn.
    void keep_lengths(Points& x) const;

private:
    const Model& model_;
    std::vector<std::array<int, 2>> edges_;
    std::vector<double> length_, rest_length_;
    std::vector<std::vector<size_t>> edges_at_;  // each vertex
};

}  // namespace drape
