// What the renderer is told: surfaces, colours, a camera. It knows nothing of simulation.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "base/image.h"
#include "base/points.h"
#include "base/rigid_motion.h"
#include "mesh/mesh.h"

namespace drape {

struct Camera {
    Vec3 from{2, 1.5, 2}, at{0, 0, 0};
    double fov_deg = 24;  // vertical
};

// The look of a cloth; colours front and back, a woven border band in a third.
struct ClothLook {
    Colour front{0.73f, 0.19f, 0.17f}, back{0.80f, 0.74f, 0.62f}, stripe{0.90f, 0.86f, 0.76f};
    bool stripes = true;
    double thread_spacing = 1.5e-3;  // between neighbouring threads [m]; drawn coarser where pixels are
};

struct DrawnCloth {
    const Mesh* mesh = nullptr;  // outlives the renderer
    ClothLook look;
};

struct DrawnSolid {
    Mesh surface;  // in the solid's own frame
    Colour colour{0.62f, 0.63f, 0.66f};
    bool is_ground = false;  // a plane: drawn as ground with grid lines, fading into the backdrop
};

// wire: the simulated triangles; tint: a colour per vertex with a colour bar; springs: line segments.
enum class Overlay { none, wire, tint, springs };

// What the colours of a tint mean.
struct ColourScale {
    std::string title;
    std::array<std::string, 3> label;     // at -1, 0 and 1
    Colour (*colour)(float t) = nullptr;  // t from -1 to 1, clamped (colour_map.h)
};

struct Segments {  // overlay springs: pairs of points, a colour per segment
    Points ends;   // 3 x 2S: columns 2s and 2s+1 are the ends of segment s
    std::vector<Colour> colour;
};

struct RenderSettings {
    int width = 1280, height = 720;
    Camera camera;
    Overlay overlay = Overlay::none;
    ColourScale scale;   // of Overlay::tint
    bool ground = true;  // draw a ground at `ground_height` if no solid is one
    double ground_height = 0;
    Eigen::AlignedBox3d bounds;  // of all that moves over the whole run: fits shadows
};

// One frame: positions per cloth (a column per simulated vertex), a pose per solid.
struct FrameInput {
    std::vector<Points> cloth;
    std::vector<Pose> solid;
    // per cloth and simulated vertex: how far its triangles are from others that they may not cross [m];
    // none: cloths may be drawn through each other
    std::vector<Eigen::VectorXd> room;
    // per cloth and simulated vertex, -1 to 1 on the scale; only read by Overlay::tint
    std::vector<Eigen::VectorXf> tint;
    Segments segments;  // only read by Overlay::springs
};

}  // namespace drape
