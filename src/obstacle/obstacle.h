// Obstacles: solids cloth cannot enter, as signed distances; and meshes, which it cannot cross. One file per
// kind; a new kind is its file, its row in the table of obstacle.cpp and its line in the README; the tests
// loop over the table.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/rigid_motion.h"
#include "mesh/mesh.h"
#include "obstacle/shape.h"

namespace drape {

// The nearest point of a solid's surface, seen from outside or inside.
struct SurfaceSample {
    double distance = 0;          // signed: negative inside [m]
    Vec3 normal = Vec3::UnitY();  // unit gradient of the distance, out of the solid
};

// A solid at rest in its own frame.
class Solid {
public:
    virtual ~Solid() = default;
    virtual SurfaceSample sample(const Vec3& p) const = 0;

    // How far inside the solid a flat triangle with sides <= `spacing` can reach when its corners are all
    // on or outside the surface [m]. 0 for a plane.
    virtual double sagitta(double spacing) const = 0;

    // Every point of the solid is within `reach()` of `centre()`; infinite for a plane.
    virtual Vec3 centre() const = 0;
    virtual double reach() const = 0;

    // The triangles of a mesh, which cloth meets as it meets cloth; null of solids that are distances. A mesh
    // bounds no solid: its sample() is that of the box around it, which no part of it is nearer than.
    virtual const Mesh* triangles() const { return nullptr; }

    // The surface as triangles for drawing, normals outward, fine enough to look smooth. A plane gives a
    // square of side `extent` around its centre.
    virtual Mesh surface(double extent) const = 0;
};

// The Hessian of the distance at p [1/m]: the principal curvatures of the surface of equal distance. By
// central differences of the normal; where the distance has a crease it is that of either side, or large.
Mat3 curvature(const Solid& solid, const Vec3& p);

struct SolidKind {
    std::string_view name;
    std::string_view summary;
    std::span<const std::string_view> keys;  // the scene keys it reads beyond `shape`, `friction`, `motion`
    // throws Error on impossible numbers; null: triangles of a file (make_mesh)
    std::unique_ptr<Solid> (*make)(const ShapeParameters&);
};

std::span<const SolidKind> solid_kinds();     // those that are distances
std::span<const SolidKind> obstacle_kinds();  // and meshes

// At least one triangle.
std::unique_ptr<Solid> make_mesh(Mesh mesh);

// A solid in the world, perhaps moving.
struct Obstacle {
    std::string kind;
    std::shared_ptr<const Solid> solid;
    RigidMotion motion;
    double friction = 0;     // Coulomb's coefficient between it and cloth [-]
    double thickness = 0;    // of a mesh: how far cloth keeps off it, besides half its own thickness [m]
    std::string place = {};  // where a scene says so, for messages; "" = nowhere

    // No point of its surface, as far out as cloth can touch it, is ever faster than this, or between two
    // times [m/s].
    double surface_speed(double from = -INFINITY, double to = INFINITY) const;
};

}  // namespace drape
