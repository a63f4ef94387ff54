// Where what stands in a glTF cache, and the JSON that tells it. The binary chunk holds, each a multiple of 4
// bytes: corners, UVs, positions and normals of every sample, times, weights.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/colour.h"

namespace drape {

struct GlbLayout {
    std::string name;
    Colour colour{};
    std::uint64_t vertices = 0, triangles = 0, samples = 0;
    bool has_uv = false;

    std::uint64_t corner_bytes() const { return 12 * triangles; }
    std::uint64_t uv_bytes() const { return has_uv ? 8 * vertices : 0; }
    std::uint64_t vector_bytes() const { return 12 * vertices; }  // positions or normals of a sample
    std::uint64_t targets() const { return samples - 1; }         // sample 0 is the mesh itself
    std::uint64_t time_bytes() const { return samples > 1 ? 4 * samples : 0; }
    std::uint64_t weight_bytes() const { return 4 * samples * targets(); }
    std::uint64_t bytes() const {
        return corner_bytes() + uv_bytes() + 2 * samples * vector_bytes() + time_bytes() + weight_bytes();
    }
};

// What the positions of a sample, or their displacements from sample 0, lie between.
struct GlbBounds {
    Eigen::Vector3f least, most;
};

// `bounds` of every sample; `last_time` is the last one's [s].
std::string glb_json(const GlbLayout& layout, const std::vector<GlbBounds>& bounds, float last_time);

}  // namespace drape
