// The slope of a function across an inner edge of a triangle mesh, from its values at vertices.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

// dg/dn at the edge's middle = sum_i weight[i] g(vertex[i]), n the unit vector in the surface, laid flat,
// that points out of the edge's first triangle. Exact for every quadratic g.
struct EdgeSlope {
    std::vector<int> vertex;
    Eigen::VectorXd weight;  // [1/m]
    double condition = 1;    // of the fit, in units of the neighbourhood's size; 1: none was needed
    bool complete = true;    // false: the surface is too narrow here to tell every quadratic (a strip one
                             // triangle wide); those it cannot tell do not count
};

// The slopes of the two triangles, mixed by their heights over the edge, are right for linear functions and,
// where the triangles are images of each other by half a turn about the edge's middle, for quadratic ones
// too. Elsewhere the weights take the least change that makes them so, over the triangles and their
// neighbours; near borders and where points lie near a conic, triangles farther out join until that is well
// conditioned.
EdgeSlope edge_slope(const Mesh& mesh, const Topology& topology, const Edge& edge);

}  // namespace drape
