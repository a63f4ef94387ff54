// What a mesh is like, in numbers a person can act on.
#pragma once

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

struct MeshQuality {
    int vertices = 0, edges = 0, triangles = 0, components = 0, boundary_loops = 0, non_manifold_edges = 0;
    double area = 0;                                                 // [m^2]
    double shortest_edge = 0, mean_edge = 0, longest_edge = 0;       // [m]
    double smallest_angle_deg = 0, largest_aspect = 0;               // longest side over smallest height
    int slivers = 0;          // triangles with an angle under 10 degrees or over 160
    // An explicit step goes as sqrt(m / k). This compares the worst vertex with the median one:
    // how many times smaller the step is because of the worst triangles, 1 = nothing lost.
    double step_cost = 1;
    int worst_triangle = -1;  // the one with the smallest angle
};

MeshQuality measure_quality(const Mesh& mesh, const Topology& topology);

}  // namespace drape
