// The makers of every kind of force, for the table in forces.cpp.
#pragma once

#include "force/force.h"

namespace drape {

MadeForce make_gravity(const Cloth&, const Surroundings&);
MadeForce make_edge_springs(const Cloth&, const Surroundings&);
MadeForce make_altitude_springs(const Cloth&, const Surroundings&);
MadeForce make_membrane(const Cloth&, const Surroundings&);
MadeForce make_bending(const Cloth&, const Surroundings&);
MadeForce make_air_drag(const Cloth&, const Surroundings&);
MadeForce make_wind(const Cloth&, const Surroundings&);

}  // namespace drape
