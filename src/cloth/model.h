// All that does not move: cloths at rest, masses, pins. Built once, const from then on.
#pragma once

#include <vector>

#include "base/rigid_motion.h"
#include "cloth/fabric.h"
#include "cloth/network.h"
#include "cloth/state.h"
#include "mesh/mesh.h"
#include "mesh/topology.h"

namespace drape {

// One cloth. Its vertices are columns first .. first + vertices() - 1 of the State.
struct Cloth {
    Mesh mesh;  // the rest shape, scaled and placed in the world
    Topology topology;
    Fabric fabric;
    Network network;
    Eigen::VectorXd mass;  // lumped, a third of each triangle to each corner [kg]
    Eigen::VectorXd area;  // the same of area [m^2]
    int first = 0;
    bool self_contact = false;  // meets itself, and every other cloth that does

    int vertices() const { return mesh.vertices(); }
};

// Vertices held, or carried along a motion; their inverse mass is 0.
struct PinGroup {
    std::vector<int> vertices;  // columns of the State
    Points anchors;             // where they start [m]
    Vec3 about = Vec3::Zero();  // the point the motion turns about [m]
    RigidMotion motion;
    bool rigid = false;  // rotations turn the group as one body; else only translations move it
};

struct Model {
    std::vector<Cloth> cloths;
    std::vector<PinGroup> pins;
    Eigen::VectorXd mass;          // per column of the State [kg]
    Eigen::VectorXd inverse_mass;  // 0 where pinned [1/kg]

    int vertices() const { return static_cast<int>(mass.size()); }
};

// A cloth from its rest shape in the world: topology, masses, spring network.
Cloth make_cloth(Mesh mesh, const Fabric& fabric);

// Appends the cloth, numbering its vertices after those already there.
void add_cloth(Model& model, Cloth cloth);

// Pins the group's vertices from now on.
void add_pins(Model& model, PinGroup group);

bool has_moving_pins(const Model& model);

// Forces jump where the shortest altitude changes (AltitudeMode::shortest).
bool has_jumping_forces(const Model& model);

// Puts pinned vertices where they belong at state.time, with their velocity.
void place_pins(const Model& model, State& state);

}  // namespace drape
