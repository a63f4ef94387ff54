// What a pattern covers: a region of the plane between closed curves.
#pragma once

#include <vector>

#include "mesh/poisson_disk.h"

namespace drape {

using Loop = std::vector<Eigen::Vector2d>;  // the corners of a closed polygon

// A closed polygon; with a radius [m] the circle about the origin that it runs round.
struct Curve {
    Loop corners;
    double radius = 0;
};

// A place is inside where it lies within an odd number of the curves.
struct Outline {
    std::vector<Curve> curves;

    Eigen::Vector2d low() const, high() const;  // of its bounding box
};

Outline rectangle_outline(double width, double depth);
Outline disc_outline(double diameter);
Outline annulus_outline(double outer, double inner);  // diameters
// Throws Error unless it is a polygon of at least three corners that does not touch itself and has an area.
Outline polygon_outline(const Loop& corners);
// The same of several, none of which touches another; a hole is one inside another.
Outline polygons_outline(const std::vector<Loop>& loops);

// Points along every curve, as far apart as the size field has it. Corners that turn by over 15 degrees are
// among them; gentler ones only where the points are as near as they are.
std::vector<Loop> border_points(const Outline& outline, const SizeField& edge_length);

// Puts a point halfway between a loop's point `after` and the next, on the curve.
void split(const Curve& curve, Loop& loop, size_t after);

// Whether places lie within an odd number of closed polygons, given as their sides in any order.
class Inside {
public:
    explicit Inside(const std::vector<Loop>& loops);
    explicit Inside(std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> sides);
    bool operator()(const Eigen::Vector2d& p) const;

private:
    size_t strip(double y) const;

    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> sides_;
    std::vector<std::vector<size_t>> strips_;  // sides by height
    double low_ = 0, strips_per_metre_ = 0;
};

double area_between(const std::vector<Loop>& loops);  // of the places inside [m^2]

}  // namespace drape
