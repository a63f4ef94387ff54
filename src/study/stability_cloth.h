// The cloths that a stability map tries methods on: small built-in ones, or a scene's.
#pragma once

#include <string>
#include <vector>

#include "integrate/method.h"
#include "simulate/simulation.h"

namespace drape {

struct StabilityCloth {
    std::string mesh;     // "alternating", "random", "slivers", or the scene's name
    std::string options;  // what is there besides edge springs: "altitude, damping"; "bare springs"
    std::string file;     // what its map's file is called, without ending
    Setup setup;          // any stiffness: with_spring_constant() sets it
};

// Three meshes of 5 x 5 vertices, held at two corners, each with and without altitude springs, bending and
// damping. The first is the regular one with bare springs.
std::vector<StabilityCloth> built_in_cloths();

inline constexpr const char* scene_file = "scene";  // StabilityCloth::file of a scene's

// A scene's cloths, pins and fabrics under its gravity, without its obstacles and its air.
StabilityCloth cloth_of_scene(const std::string& name, const Setup& setup);

// Mean of a property of the edge springs of all cloths.
double mean_over_springs(const Model& model, double Spring::*value);

// Stretch and bending scaled alike so that edge springs are of `stiffness` on average [N/m].
Setup with_spring_constant(const Setup& setup, double stiffness);

// What theory knows of small motion about the start: the fastest modes, of all forces and of those that a
// method which projects springs takes explicitly.
struct SmallMotion {
    Spectrum all, unprojected;
    bool is_small = true;  // the cloth's weight on one spring would stretch it by less than a tenth
    // The longest step at which `method` keeps every mode bounded [s]; infinite if it does with any.
    double limit(const Method& method) const;
};
SmallMotion small_motion(const Setup& setup);

}  // namespace drape
