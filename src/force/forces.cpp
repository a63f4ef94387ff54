#include <array>

#include "force/kinds.h"

namespace drape {

namespace {

constexpr std::array kinds{
    ForceKind{"gravity", make_gravity},
    ForceKind{"edge springs", make_edge_springs},
    ForceKind{"altitude springs", make_altitude_springs},
    ForceKind{"membrane", make_membrane},
    ForceKind{"bending", make_bending},
    ForceKind{"air drag", make_air_drag},
    ForceKind{"wind", make_wind},
};

}  // namespace

std::span<const ForceKind> force_kinds() {
    return kinds;
}

}  // namespace drape
