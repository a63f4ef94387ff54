// A small cloth within an obstacle's barrier, and scenes of cloth and obstacles written by hand.
#pragma once

#include "contact/obstacle_contact.h"
#include "support/setups.h"

namespace drape::test {

// Turns and shifts at once; at t = 0.4 both are under way.
RigidMotion wobble();

// A sheet of 6 cm laid on the solid where it faces a random direction, jittered, each vertex moving anyhow.
struct Touching {
    Model model;
    ObstacleContact contact;
    double time = 0.4;
    Points x, v;

    Touching(const Obstacle& obstacle, unsigned seed, double speed = 1);
    static Fabric fabric();
    double kinetic_energy() const;
};

// Every solid, at rest and moving, with that much friction.
std::vector<std::pair<std::string, Obstacle>> every_obstacle(double friction = 0);

// A cloth that starts as its mesh stands, and obstacles.
Setup setup_of(Mesh mesh, const Fabric& fabric, std::vector<Obstacle> obstacles, double frame_rate,
               int frames);

Mesh raised(Mesh mesh, double height);

// Energy that is neither there, nor booked as heat, nor put in, since a start with `start` [J].
double drift(const Simulation& simulation, double start);

// The least distance of a cloth's triangles from an obstacle, on a lattice of `parts` a side.
double lattice_distance(const Faces& faces, In x, const Obstacle& obstacle, double time, int parts = 25);

}  // namespace drape::test
