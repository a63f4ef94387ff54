// A scene as its author wrote it, with every default filled in: plain data, SI units, nothing built yet.
// reader.h makes it from a file, builder.h makes a simulation of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "base/points.h"
#include "base/rigid_motion.h"
#include "cloth/fabric.h"
#include "force/wind.h"
#include "mesh/pattern.h"
#include "obstacle/shape.h"
#include "toml/place.h"

namespace drape {

// Rest shape to world: scale, then rotation about x, y, z, then translation.
struct Placement {
    Vec3 translate = Vec3::Zero();
    Vec3 rotate_deg = Vec3::Zero();
    double scale = 1;
};

struct StartDescription {
    Vec3 velocity = Vec3::Zero();
    Vec3 scale = Vec3::Ones();  // of the rest shape about its centre, before placement; 0 flattens it
    std::string mesh;  // a file with the start positions in the same vertex order; "" = the rest shape
};

struct PinDescription {
    // exactly one of these three says which vertices
    std::optional<Vec3> near;                // the nearest vertex, in placed coordinates
    std::optional<double> within;            // ... no farther than this [m]; default one mean edge
    std::optional<std::array<Vec3, 2>> box;  // all vertices in it, in placed coordinates
    std::optional<int> boundary;             // all vertices of this boundary loop, 0 = the longest
    std::vector<Keyframe> motion;            // empty: held still
    std::optional<Vec3> about;               // the point rotations turn about; default the group's centre
    bool rigid = false;                      // the group keeps its start shape, and may be moved as one body
    Place place;
};

struct ClothColours {
    std::optional<Colour> front, back, stripe;  // none: the picture's palette chooses
    bool stripes = true;                        // the woven border band
};

// Where an earlier run was curved, for an adaptive pattern: scene/curved_places.h.
struct CurvedFiles {
    std::string mesh, positions;  // relative to the scene's folder; "" = none
    Place place;
};

struct ClothDescription {
    std::string mesh;                     // a file, relative to the scene's folder; "" = a pattern
    std::string pattern = "alternating";  // read only if mesh is ""
    PatternSize pattern_size;
    CurvedFiles curved;  // makes the pattern finer
    Placement placement;
    StartDescription start;
    std::string fabric_name;  // the preset the fabric is, or starts from; "" = from nothing
    Fabric fabric;
    std::vector<PinDescription> pins;
    bool self_contact = false;
    ClothColours colours;
    Place place, mesh_place, fabric_place, start_mesh_place;
};

struct ObstacleDescription {
    std::string shape;
    ShapeParameters parameters;  // of solids that are distances
    std::string mesh;            // of a mesh: its file, relative to the scene's folder
    Placement placement;         // ... placed in its own frame, before motion
    double thickness = 0.003;    // ... how far cloth keeps off it, besides half its own thickness [m]
    double friction = 0.3;       // Coulomb's coefficient between it and cloth [-]
    std::vector<Keyframe> motion;
    std::optional<Vec3> about;  // the point its rotations turn about; default its centre [m]
    Colour colour{0x9e / 255.0f, 0xa1 / 255.0f, 0xa8 / 255.0f};
    Place place, mesh_place;
};

struct CameraDescription {
    Vec3 from = Vec3::Zero(), at = Vec3::Zero();
    double fov_deg = 24;  // vertical
};

struct LookDescription {  // the [render] table
    std::array<int, 2> size{1280, 720};
    std::optional<CameraDescription> camera;  // none: framed automatically
    std::string overlay = "none";             // none, wire, strain, springs, error, contacts
    bool ground = true;                       // draw a ground even where no plane obstacle gives one
};

struct AccuracyDescription {
    std::string method = "auto";      // auto: drape chooses
    std::optional<double> step;       // [s]; none: drape chooses
    std::optional<double> tolerance;  // of the worst frame's RMS error [m]; none: no promise
    std::optional<double> budget;     // of wall time, pictures included [s]
    Place place;
};

// What a run of the scene should come to. Nothing depends on it: whoever runs the scene may hold drape to it.
struct Expectation {
    std::string outcome = "runs";          // runs, refused (exit 2) or stops (exit 4)
    std::string because;                   // a part of the line that refuses or stops; "" = any
    std::optional<double> largest_strain;  // of every frame, at most [-]
    std::optional<double> fastest;         // of every frame, at most [m/s]
};

struct SceneDescription {
    std::string file;        // as given
    std::string folder;      // of the file: paths in the scene are relative to it
    std::string name;        // default: the file's stem
    double duration = 1;     // [s]
    double frame_rate = 30;  // [1/s]
    Vec3 gravity{0, -9.81, 0};
    std::uint64_t seed = 1;
    AccuracyDescription accuracy;
    std::vector<ClothDescription> cloths;
    std::vector<ObstacleDescription> obstacles;
    AirDescription air;
    LookDescription look;
    std::optional<Expectation> expected;

    int frames() const;  // round(duration * frame_rate)
    std::string path_to(
        const std::string& relative) const;  // a path of the scene, as the program can open it
};

}  // namespace drape
