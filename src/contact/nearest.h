// How near two pieces of cloth are: a vertex and a triangle, or two edges.
//
// The way between their nearest points is r = sum c_i x_i over the four vertices, sum c_i = 0; the place on
// each piece is its least. Where it can move, along slopes dc/dt, moving it changes the distance by nothing
// to first order (the envelope theorem), so the gradient of the distance by x_i is c_i n, n = r / |r|.
#pragma once

#include "base/points.h"

namespace drape {

struct Nearest {
    double weight[4];    // c_i
    Vec3 normal;         // n; zero where they touch
    double distance;     // |r| [m]
    double slope[2][4];  // dc/dt of the places that are free to move
    int free;            // how many of those there are
};

// Weights are 1, -b0, -b1, -b2: the vertex comes first.
Nearest nearest_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

// Weights are 1 - s, s, -(1 - t), -t. Of parallel edges, any of the nearest points.
Nearest nearest_of_edges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace drape
