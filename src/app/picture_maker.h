// Hands a simulation's frames to the renderer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "scene/description.h"
#include "simulate/simulation.h"

namespace drape {

// The cloth as it is in `state`, among the simulation's obstacles at that time; `vertex_error` [m], empty if
// not known, is what the overlay of that name shows.
FrameInput frame_input(const std::string& overlay, const Simulation& simulation, const State& state,
                       const Eigen::VectorXf& vertex_error = {});

// All a renderer of the scene is made of, as far as it stays the same from frame to frame.
struct DrawnScene {
    RenderSettings settings;
    std::vector<std::shared_ptr<const Mesh>> meshes;  // of the cloths: a run may end the simulation before
    std::vector<DrawnCloth> cloths;
    std::vector<DrawnSolid> solids;
};

// The room the camera sees is judged from where the simulation stands.
DrawnScene drawn_scene(const SceneDescription& scene, const Simulation& simulation);

// The scene must outlive what is returned.
Renderer make_renderer(const DrawnScene& scene);

}  // namespace drape
