// Hands a simulation's frames to the renderer.
#pragma once

#include <memory>
#include <string>

#include "base/image.h"
#include "render/renderer.h"
#include "scene/description.h"
#include "simulate/simulation.h"

namespace drape {

class PictureMaker {
public:
    PictureMaker(const SceneDescription& scene, const Simulation& simulation);

    // the cloth as it is in `state`, among the simulation's obstacles at that time; `vertex_error` [m], empty
    // if not known, is what the overlay of that name shows
    Image draw(const Simulation& simulation, const State& state, const Eigen::VectorXf& vertex_error = {});
    std::string renderer() const { return renderer_.description(); }

private:
    std::string overlay_;
    Renderer renderer_;
};

}  // namespace drape
