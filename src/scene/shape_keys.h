// What each key of any kind of solid means; which of them a kind reads stands in its row
// (obstacle/obstacle.h).
#pragma once

#include <array>
#include <string_view>

#include "obstacle/shape.h"
#include "toml/keys.h"

namespace drape {

template <class Type>
struct ShapeKey {
    std::string_view name;
    Type ShapeParameters::*member;
    Quantity quantity;
};

constexpr std::array shape_vectors{
    ShapeKey<Vec3>{"centre", &ShapeParameters::centre, any("m")},
    ShapeKey<Vec3>{"normal", &ShapeParameters::normal, any()},
    ShapeKey<Vec3>{"axis", &ShapeParameters::axis, any()},
    ShapeKey<Vec3>{"from", &ShapeParameters::from, any("m")},
    ShapeKey<Vec3>{"to", &ShapeParameters::to, any("m")},
    ShapeKey<Vec3>{"size", &ShapeParameters::size, positive("m")},
    ShapeKey<Vec3>{"rotate_deg", &ShapeParameters::rotate_deg, any("degrees")},
};

constexpr std::array shape_numbers{
    ShapeKey<double>{"radius", &ShapeParameters::radius, positive("m")},
    ShapeKey<double>{"tube_radius", &ShapeParameters::tube_radius, positive("m")},
    ShapeKey<double>{"height", &ShapeParameters::height, positive("m")},
    ShapeKey<double>{"rounding", &ShapeParameters::rounding, not_negative("m")},
};

}  // namespace drape
