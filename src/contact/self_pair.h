// The contact potential of two pieces of cloth, a vertex and a triangle or two edges, at a distance g:
//   E = A m psi(g)
// with the barrier psi (barrier.h) and A the area that the pair stands for. Where edges become parallel their
// nearest points jump, so the potential of two edges u, v fades out there,
//   m = 1 - (1 - y)^3,  y = |u x v|^2 / (0.01 |u0|^2 |v0|^2) below 1 (5.7 degrees), else 1,
// twice continuously differentiable; ends of such edges still meet triangles. Li et al., Incremental
// Potential Contact (2020), fade it out likewise, with a quadratic. At any angle but 0 it still rises
// without bound as g falls to 0.
//
// With w the weights c_i of nearest.h, slopes t_k and r = g n, the square g^2 / 2 has the Hessian
//   c c' (x) I - F D^-1 F',   F_k = c (x) r_k + t_k (x) r,   r_k = sum t_k,i x_i,   D_kl = r_k . r_l,
// and g that, less the gradient's square, over g. Forces on the four sum to zero, and have no torque: each
// of them works along n between two points of one line, and m changes with no rotation.
#pragma once

#include "contact/barrier.h"
#include "contact/nearest.h"

namespace drape {

struct SelfPair {
    int vertex[4];  // columns of the State: the vertex, then the triangle; or both ends of either edge
    int layers;     // which two cloths' barrier
    bool edges;
    double area;                // A [m^2]
    double fading;              // 0.01 |u0|^2 |v0|^2 of edges [m^4]
    Vec3 apart = Vec3::Zero();  // the normal when the pair was last measured
};

using PairPoints = Eigen::Matrix<double, 3, 4>;
using PairMatrix = Eigen::Matrix<double, 12, 12>;

PairPoints points_of(const SelfPair& pair, const double* x);
Nearest nearest_of(const SelfPair& pair, const PairPoints& x);

// How far the pieces lie apart along pair.apart: no more than their distance, and where that is as long ago
// as the pair has hardly turned, hardly less. Along straight ways of the vertices it is never less than at
// both ends.
double separation(const SelfPair& pair, const double* x);

// How much of the potential there is.
struct Fade {
    double part = 1, slope = 0, bend = 0;  // m, m', m'' by y
    double square = 0;                     // |u x v|^2 [m^4]
};
Fade fade_of(const SelfPair& pair, const PairPoints& x);

double pair_energy(const SelfPair& pair, const Barrier& barrier, const PairPoints& x);

// What fading pushes the four vertices with, where the barrier alone has `energy` per area [N].
PairPoints fading_force(const SelfPair& pair, const PairPoints& x, const Fade& fade, double energy);

// Bounds any row sum of the stiffness that fading adds [N/m].
double fading_stiffness(const SelfPair& pair, const PairPoints& x, const Fade& fade, double energy);

// d2E/dx2; needs 0 < g.
PairMatrix pair_hessian(const SelfPair& pair, const Barrier& barrier, const PairPoints& x);

}  // namespace drape
