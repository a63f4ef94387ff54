// Takes apart a start that crosses itself, other cloths or meshes, for a user who asks for it.
//
// Two triangles that cross share a segment; all segments together are the curves where surfaces go through
// each other. An end P of a segment, with R the unit vector from it to the other end, is where an edge E of
// one triangle pierces the other, whose normal is N. P stays on both: where the place on the edge moves by e
// and that on the triangle by t, P moves by e + E N.(t - e) / (N.E), and the segment grows by -R times that:
// its gradient is -R + N (R.E) / (N.E) at the edge and -N (R.E) / (N.E) at the triangle. Vertices follow the
// sum of these downhill; neighbours go with them, and edges keep their lengths. What is through by a corner
// or a fold is drawn out, whichever side it came from. Sheets that cross from border to border have a curve
// that no small move shortens: they stay as they are, and that is said.
//
// When nothing crosses, pairs are pushed apart to a share of the thickness, which contact can start from.
#pragma once

#include <vector>

#include "cloth/model.h"
#include "contact/self_contact.h"
#include "mesh/crossings.h"

namespace drape {

struct Untangled {
    Crossings before;
    int rounds = 0;           // of moves
    double largest_move = 0;  // of a vertex [m]
};

// Moves what no pin holds of start.x. Throws Error where triangles still cross at the end, or lie too near
// each other. Does nothing where nothing crosses.
Untangled untangle(const Model& model, const std::vector<Obstacle>& obstacles, const Vec3& gravity,
                   State& start, double duration);

}  // namespace drape
