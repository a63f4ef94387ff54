#include "app/picture_maker.h"

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "contact/self_contact.h"
#include "render/colour_map.h"
#include "render/palette.h"
#include "render/smooth_surface.h"
#include "simulate/room.h"
#include "simulate/strain.h"

namespace drape {

namespace {

constexpr double strain_range = 0.05;  // at the ends of the colour bar
// of the error's scale, which is logarithmic [m]
constexpr double least_error = 1e-6, most_error = 1e-1;

ColourScale no_scale() {
    return {"", {}, diverging_colour};
}
ColourScale strain_scale() {
    return {"strain", {"-5 %", "0", "+5 %"}, diverging_colour};
}
ColourScale error_scale() {
    return {"error mm", {"0.001", "0.3", "100"}, rising_colour};
}

// What [render] overlay may name.
struct OverlayKind {
    std::string_view name;
    Overlay overlay;
    ColourScale (*scale)();
};
constexpr std::array overlays{
    OverlayKind{"none", Overlay::none, no_scale}, OverlayKind{"wire", Overlay::wire, no_scale},
    OverlayKind{"strain", Overlay::tint, strain_scale}, OverlayKind{"springs", Overlay::springs, no_scale},
    OverlayKind{"error", Overlay::tint, error_scale}};

// Errors of a cloth's vertices on the scale; those not known are shown as none.
Eigen::VectorXf error_tint(const Cloth& cloth, const Eigen::VectorXf& error) {
    if (error.size() == 0) return Eigen::VectorXf::Constant(cloth.vertices(), -1);
    const auto decades = static_cast<float>(std::log10(most_error / least_error));
    const auto own = error.segment(cloth.first, cloth.vertices()).array() / static_cast<float>(least_error);
    return (own.max(1e-6f).log10() / decades * 2 - 1).matrix();
}

RenderSettings settings_of(const SceneDescription& scene, const Simulation& simulation) {
    RenderSettings settings;
    settings.width = scene.look.size[0];
    settings.height = scene.look.size[1];
    const OverlayKind& kind = find_named(overlays, "overlay", scene.look.overlay);
    settings.overlay = kind.overlay;
    settings.scale = kind.scale();
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

Segments springs_of(const Model& model, In x) {
    Segments segments;
    size_t count = 0;
    for (const Cloth& cloth : model.cloths) count += cloth.network.edges.size() + cloth.network.bends.size();
    segments.ends.resize(3, static_cast<Eigen::Index>(2 * count));
    for (const Cloth& cloth : model.cloths) {
        for (const auto* springs : {&cloth.network.edges, &cloth.network.bends}) {
            for (const Spring& spring : *springs) {
                const Vec3 a = x.col(cloth.first + spring.a);
                const Vec3 b = x.col(cloth.first + spring.b);
                const auto s = static_cast<Eigen::Index>(segments.colour.size());
                segments.ends.col(2 * s) = a;
                segments.ends.col(2 * s + 1) = b;
                const double strain = spring.rest_length > 0 ? (b - a).norm() / spring.rest_length - 1 : 0;
                segments.colour.push_back(diverging_colour(static_cast<float>(strain / strain_range)));
            }
        }
    }
    return segments;
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
    for (const Cloth& cloth : simulation.model().cloths) {
        frame.cloth.emplace_back(state.x.middleCols(cloth.first, cloth.vertices()));
        if (overlay == "strain")
            frame.tint.push_back(vertex_strain(cloth, state.x) / static_cast<float>(strain_range));
        if (overlay == "error") frame.tint.push_back(error_tint(cloth, vertex_error));
    }
    frame.room = room_between(simulation, state);
    for (const Obstacle& obstacle : simulation.obstacles())
        frame.solid.push_back(obstacle.motion.at(state.time).pose);
    if (overlay == "springs") frame.segments = springs_of(simulation.model(), state.x);
    return frame;
}

}  // namespace drape
