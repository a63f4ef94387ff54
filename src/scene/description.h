// A scene as its author wrote it, with every default filled in: plain data, SI units, nothing built yet.
// reader.h makes it from a file, builder.h makes a simulation of it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/points.h"
#include "base/rigid_motion.h"
#include "cloth/fabric.h"
#include "force/wind.h"
#include "mesh/pattern.h"
#include "obstacle/shape.h"

namespace drape {

// Where something stands in the scene file, for messages: "scenes/flag.toml:12:3".
struct Place {
    std::string text;
};

// Rest shape to world: scale, then rotation about x, y, z, then translation.
struct Placement {
    Vec3 translate = Vec3::Zero();
    Vec3 rotate_deg = Vec3::Zero();
    double scale = 1;
};

struct StartDescription {
    Vec3 velocity = Vec3::Zero();
    Vec3 scale = Vec3::Ones();  // of the rest shape about its centre, before placement
    std::string mesh;           // a file with the start positions in the same vertex order; "" = the rest shape
};

struct PinDescription {
    // exactly one of these three says which vertices
    std::optional<Vec3> near;                  // the nearest vertex, in placed coordinates
    std::optional<double> within;              // ... no farther than this [m]; default one mean edge
    std::optional<std::array<Vec3, 2>> box;    // all vertices in it, in placed coordinates
    std::optional<int> boundary;               // all vertices of this boundary loop, 0 = the longest
    std::vector<Keyframe> motion;              // empty: held still
    std::optional<Vec3> about;                 // the point rotations turn about; default the group's centre
    bool rigid = false;                        // the group keeps its start shape, and may be moved as one body
    Place place;
};

struct ClothDescription {
    std::string mesh;  // file, or ""
    std::string pattern = "alternating";
    PatternSize pattern_size;
    Placement placement;
    StartDescription start;
    std::string fabric_name;  // preset, or "" for a table of its own
    Fabric fabric;
    std::vector<PinDescription> pins;
    bool self_contact = false;
    Place place, mesh_place, fabric_place, start_mesh_place;
};

struct ObstacleDescription {
    std::string shape;
    ShapeParameters parameters;
    double friction = 0.3;
    std::vector<Keyframe> motion;
    Place place;
};

struct CameraDescription {
    Vec3 from = Vec3::Zero(), at = Vec3::Zero();
    double fov_deg = 24;  // vertical
};

struct LookDescription {  // of the [render] table; colours are sRGB 0..1
    std::array<int, 2> size{1280, 720};
    std::optional<CameraDescription> camera;  // none: framed automatically
    std::string overlay = "none";             // none, wire, strain, springs
    std::vector<std::array<double, 3>> front, back, stripe;  // a colour per cloth; fewer: the palette goes on
    bool stripes = true;                      // the woven border band
    bool ground = true;                       // draw a ground even where no plane obstacle gives one
};

struct AccuracyDescription {
    std::string method;  // "" = drape chooses
    std::optional<double> step;  // [s]
    Place place;
};

struct SceneDescription {
    std::string file;    // as given
    std::string folder;  // paths in the scene are relative to it
    std::string name;
    double duration = 1;     // [s]
    double frame_rate = 30;  // [1/s]
    Vec3 gravity{0, -9.81, 0};
    std::uint64_t seed = 1;
    AccuracyDescription accuracy;
    std::vector<ClothDescription> cloths;
    std::vector<ObstacleDescription> obstacles;
    AirDescription air;
    LookDescription look;

    int frames() const;  // round(duration * frame_rate)
};

}  // namespace drape
