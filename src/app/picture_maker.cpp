#include "app/picture_maker.h"

#include <algorithm>

#include "app/overlays.h"
#include "contact/self_contact.h"
#include "render/palette.h"
#include "render/smooth_surface.h"
#include "simulate/room.h"

namespace drape {

namespace {

RenderSettings settings_of(const SceneDescription& scene, const Simulation& simulation) {
    RenderSettings settings;
    settings.width = scene.look.size[0];
    settings.height = scene.look.size[1];
    const OverlayKind& overlay = overlay_named(scene.look.overlay);
    settings.overlay = overlay.drawn;
    settings.scale = overlay.scale;
    settings.bounds = room_of(simulation);
    if (scene.look.camera)
        settings.camera = {scene.look.camera->from, scene.look.camera->at, scene.look.camera->fov_deg};
    else
        settings.camera = frame_automatically(settings.bounds, double(settings.width) / settings.height);
    settings.ground = scene.look.ground;
    settings.ground_height = settings.bounds.min().y() - 0.02 * settings.bounds.sizes().maxCoeff();
    return settings;
}

std::vector<DrawnCloth> cloths_of(const SceneDescription& scene,
                                  const std::vector<std::shared_ptr<const Mesh>>& meshes) {
    std::vector<DrawnCloth> cloths;
    for (size_t i = 0; i < scene.cloths.size(); ++i) {
        const ClothColours& asked = scene.cloths[i].colours;
        ClothLook look = palette(static_cast<int>(i));
        look.front = asked.front.value_or(look.front);
        look.back = asked.back.value_or(look.back);
        look.stripe = asked.stripe.value_or(look.stripe);
        look.stripes = asked.stripes;
        cloths.push_back({meshes[i].get(), look});
    }
    return cloths;
}

std::vector<DrawnSolid> solids_of(const SceneDescription& scene, const Simulation& simulation) {
    const double extent = 40 * room_of(simulation).sizes().maxCoeff();
    std::vector<DrawnSolid> solids;
    for (size_t i = 0; i < simulation.obstacles().size(); ++i) {
        const Obstacle& obstacle = simulation.obstacles()[i];
        const bool level = obstacle.kind == "plane" && !obstacle.motion.moves() &&
                           scene.obstacles[i].parameters.normal.normalized().y() > 0.999;
        const double side = level ? extent : extent / 10;
        solids.push_back({obstacle.solid->surface(side), scene.obstacles[i].colour, level});
    }
    return solids;
}

// Smoothing moves what is drawn by far less than half an edge.
std::vector<Eigen::VectorXd> room_between(const Simulation& simulation, const State& state) {
    const Model& model = simulation.model();
    if (std::all_of(model.cloths.begin(), model.cloths.end(),
                    [](const Cloth& cloth) { return smoothing_levels(cloth.mesh.triangles()) == 0; }))
        return {};
    const std::unique_ptr<SelfContact> contact =
        SelfContact::make(model, simulation.obstacles(), Vec3::Zero(), state, 0);
    if (!contact) return {};
    const Eigen::VectorXd all = contact->room(state.x, state.time, contact->mean_edge() / 2);
    std::vector<Eigen::VectorXd> room;
    for (const Cloth& cloth : model.cloths) room.emplace_back(all.segment(cloth.first, cloth.vertices()));
    return room;
}

}  // namespace

DrawnScene drawn_scene(const SceneDescription& scene, const Simulation& simulation) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const Cloth& cloth : simulation.model().cloths)
        meshes.push_back(std::make_shared<const Mesh>(cloth.mesh));
    std::vector<DrawnCloth> cloths = cloths_of(scene, meshes);
    return {settings_of(scene, simulation), std::move(meshes), std::move(cloths),
            solids_of(scene, simulation)};
}

Renderer make_renderer(const DrawnScene& scene) {
    return {scene.settings, scene.cloths, scene.solids};
}

FrameInput frame_input(const std::string& overlay, const Simulation& simulation, const State& state,
                       const Eigen::VectorXf& vertex_error) {
    FrameInput frame;
    for (const Cloth& cloth : simulation.model().cloths)
        frame.cloth.emplace_back(state.x.middleCols(cloth.first, cloth.vertices()));
    frame.room = room_between(simulation, state);
    for (const Obstacle& obstacle : simulation.obstacles())
        frame.solid.push_back(obstacle.motion.at(state.time).pose);
    overlay_named(overlay).fill(frame, simulation, state, vertex_error);
    return frame;
}

}  // namespace drape
