// What [render] overlay may name: colours and lines that show more of a cloth than how it looks.
#pragma once

#include <string_view>

#include "render/picture.h"
#include "simulate/simulation.h"

namespace drape {

struct OverlayKind {
    std::string_view name;
    Overlay drawn;
    ColourScale scale;
    // adds what a frame shows of it; `vertex_error` [m] is empty where it is not known
    void (*fill)(FrameInput& frame, const Simulation& simulation, const State& state,
                 const Eigen::VectorXf& vertex_error);
};

// Throws Error where there is none of that name.
const OverlayKind& overlay_named(std::string_view name);

}  // namespace drape
