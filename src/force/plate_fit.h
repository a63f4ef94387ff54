// Second derivatives of a function on a triangle mesh, by a quadratic fit around each triangle at rest.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

// g_uu, g_uv, g_vv at the triangle = sum_i weight(., i) g(vertex[i]); u, v are metres in the triangle's
// plane. Exact for every quadratic function of (u, v).
struct CurvatureStencil {
    std::vector<int> vertex;
    Eigen::Matrix3Xd weight;  // rows uu, uv, vv [1/m^2]
    double condition = 0;     // of the fit, in units of the triangle's size
    bool complete = true;     // false: the surface is too narrow here to see every curvature (a strip one
                              // triangle wide); those it cannot see count as zero
};

// The fit takes the triangle's corners and, unfolded about the shared edges into its plane, those of its
// three neighbours: six points for six coefficients. At borders, and where six points lie near a conic,
// triangles farther out join until the fit is sound. Unfolding keeps lengths, so cloth that is curved at rest
// (a skirt) is taken as the flat panel it is cut from: fabric has no curvature of its own.
CurvatureStencil curvature_stencil(const Mesh& mesh, const Topology& topology, int triangle);

}  // namespace drape
