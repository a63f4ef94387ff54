// Where an adaptive pattern is finer, and by how much: its edge length from place to place.
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "mesh/poisson_disk.h"

namespace drape {

// How much a surface was once seen to bend at a place.
struct CurvedPlace {
    Eigen::Vector2d uv;    // 0 .. 1 across the pattern's bounding box
    double curvature = 0;  // [1/m]
};

inline constexpr double degrees_a_radian = 180 / std::numbers::pi;

struct Finer {
    std::vector<Eigen::Vector2d> points;                // edges are `finest` here [m]
    std::vector<std::array<Eigen::Vector2d, 2>> lines;  // and along these
    std::vector<CurvedPlace> curved;      // here so short that the surface turns by `turn` along one
    double finest = 0;                    // [m]; 0: a quarter of what the divisions give
    double growth = 0.25;                 // of an edge, over the distance from where it is fine
    double turn = 15 / degrees_a_radian;  // [rad]

    bool anywhere() const { return !points.empty() || !lines.empty() || !curved.empty(); }
};

// Edges of `coarse` [m] but where it is finer, in a bounding box.
SizeField finer_field(const Finer& finer, double coarse, const Eigen::Vector2d& low,
                      const Eigen::Vector2d& high);

// How many vertices a field asks for over the whole bounding box: its area in squares of the edge.
double vertices_asked(const SizeField& edge_length, const Eigen::Vector2d& low, const Eigen::Vector2d& high);

}  // namespace drape
