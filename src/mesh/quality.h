// What a mesh is like, in numbers a person can act on.
#pragma once

#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

struct MeshQuality {
    int vertices = 0, edges = 0, triangles = 0, components = 0, boundary_loops = 0, non_manifold_edges = 0;
    double area = 0;                                            // [m^2]
    double shortest_edge = 0, mean_edge = 0, longest_edge = 0;  // [m]
    double smallest_angle_deg = 0, largest_aspect = 0;          // longest side over smallest height
    int slivers = 0;  // triangles with an angle under 10 degrees or over 160
    // How many times smaller an explicit step is because of the worst vertex; 1 = nothing lost. The step goes
    // as sqrt(mass / stiffness); on a sheet of unit density and unit membrane stiffness vertex i has
    //   mass m_i = sum A_f / 3,  stiffness k_i = sum A_f / h_fi^2   over its triangles f, h_fi: its height in
    //   f,
    // k_i being the diagonal of the finite element Laplacian. step_cost = sqrt(max k_i/m_i / median k_i/m_i).
    double step_cost = 1;
    int worst_triangle = -1;  // the one with the smallest angle
};

MeshQuality measure_quality(const Mesh& mesh, const Topology& topology);

}  // namespace drape
