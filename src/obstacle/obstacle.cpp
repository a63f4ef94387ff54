#include "obstacle/obstacle.h"

#include <array>

#include "obstacle/kinds.h"

namespace drape {

namespace {

constexpr std::array<std::string_view, 2> plane_keys{"centre", "normal"};
constexpr std::array<std::string_view, 2> sphere_keys{"centre", "radius"};
constexpr std::array<std::string_view, 3> capsule_keys{"from", "to", "radius"};
constexpr std::array<std::string_view, 4> box_keys{"centre", "size", "rotate_deg", "rounding"};
constexpr std::array<std::string_view, 5> cylinder_keys{"centre", "axis", "radius", "height", "rounding"};
constexpr std::array<std::string_view, 4> torus_keys{"centre", "axis", "radius", "tube_radius"};

constexpr std::array<std::string_view, 3> mesh_keys{"mesh", "place", "thickness"};

constexpr std::array kinds{
    SolidKind{"plane", "half space below a plane", plane_keys, make_plane},
    SolidKind{"sphere", "ball", sphere_keys, make_sphere},
    SolidKind{"capsule", "segment with a radius", capsule_keys, make_capsule},
    SolidKind{"box", "cuboid, its edges rounded or sharp", box_keys, make_box},
    SolidKind{"cylinder", "round bar with flat caps, its rims rounded or sharp", cylinder_keys,
              make_cylinder},
    SolidKind{"torus", "ring", torus_keys, make_torus},
    SolidKind{"mesh", "triangles of a file, closed or open, met from either side", mesh_keys, nullptr},
};

}  // namespace

double Obstacle::surface_speed(double from, double to) const {
    constexpr double far_out = 1e3;  // on a plane that turns [m]
    if (!motion.moves()) return 0;
    const double reach = solid->reach() + (solid->centre() - motion.about()).norm();
    return motion.top_speed(std::isfinite(reach) ? reach : far_out, from, to);
}

Mat3 curvature(const Solid& solid, const Vec3& p) {
    // relative errors of (step / radius)^2 and of round-off / step balance for radii of millimetres and more
    constexpr double step = 1e-6;
    Mat3 hessian;
    for (int k = 0; k < 3; ++k) {
        const Vec3 offset = step * Vec3::Unit(k);
        hessian.col(k) = (solid.sample(p + offset).normal - solid.sample(p - offset).normal) / (2 * step);
    }
    return (hessian + hessian.transpose()) / 2;
}

std::span<const SolidKind> solid_kinds() {
    return std::span(kinds).first(kinds.size() - 1);
}

std::span<const SolidKind> obstacle_kinds() {
    return kinds;
}

}  // namespace drape
