// Hands a simulation's frames to the renderer.
#pragma once

#include <string>

#include "base/image.h"
#include "render/renderer.h"
#include "scene/description.h"
#include "simulate/simulation.h"

namespace drape {

// The cloth as it is in `state`, among the simulation's obstacles at that time; `vertex_error` [m], empty if
// not known, is what the overlay of that name shows.
FrameInput frame_input(const std::string& overlay, const Simulation& simulation, const State& state,
                       const Eigen::VectorXf& vertex_error = {});

class PictureMaker {
public:
    PictureMaker(const SceneDescription& scene, const Simulation& simulation);

    Image draw(const FrameInput& frame) { return renderer_.draw(frame); }
    std::string renderer() const { return renderer_.description(); }

private:
    Renderer renderer_;
};

}  // namespace drape
