#include "app/overlays.h"

#include <array>
#include <cmath>

#include "base/names.h"
#include "contact/contact.h"
#include "contact/surfaces.h"
#include "mesh/crossings.h"
#include "render/colour_map.h"
#include "simulate/strain.h"

namespace drape {

namespace {

constexpr float strain_range = 0.05f;  // at the ends of the colour bar
// of the error's scale, which is logarithmic [m]
constexpr float least_error = 1e-6f, most_error = 1e-1f;

void leave_empty(FrameInput&, const Simulation&, const State&, const Eigen::VectorXf&) {}

void show_strain(FrameInput& frame, const Simulation& simulation, const State& state,
                 const Eigen::VectorXf&) {
    for (const Cloth& cloth : simulation.model().cloths)
        frame.tint.push_back(vertex_strain(cloth, state.x) / strain_range);
}

// Errors that are not known are shown as none.
void show_error(FrameInput& frame, const Simulation& simulation, const State&, const Eigen::VectorXf& error) {
    const float decades = std::log10(most_error / least_error);
    for (const Cloth& cloth : simulation.model().cloths) {
        if (error.size() == 0) {
            frame.tint.push_back(Eigen::VectorXf::Constant(cloth.vertices(), -1));
            continue;
        }
        const auto own = error.segment(cloth.first, cloth.vertices()).array() / least_error;
        frame.tint.emplace_back((own.max(1e-6f).log10() / decades * 2 - 1).matrix());
    }
}

// Corners of triangles that cross others, be it that contact minds or not.
std::vector<bool> crossing_vertices(Surfaces& surfaces, const State& state) {
    const std::vector<Cloth>& all = surfaces.model().cloths;
    Eigen::Index count = 0;
    for (const Cloth& surface : all) count += surface.mesh.faces.cols();
    Faces faces(3, count);
    count = 0;
    for (const Cloth& surface : all) {
        faces.middleCols(count, surface.mesh.faces.cols()) = surface.mesh.faces.array() + surface.first;
        count += surface.mesh.faces.cols();
    }
    const auto is_cloth = [&](int face) { return faces(0, face) < surfaces.columns(); };
    const Crossings crossings =
        count_crossings(faces, surfaces.positions(state.x, state.time),
                        [&](int one, int two) { return is_cloth(one) || is_cloth(two); });
    std::vector<bool> crosses(static_cast<size_t>(state.x.cols()));
    for (Eigen::Index f = 0; f < faces.cols(); ++f)
        if (crossings.crosses[static_cast<size_t>(f)] && is_cloth(static_cast<int>(f)))
            for (const int v : faces.col(f)) crosses[static_cast<size_t>(v)] = true;
    return crosses;
}

// -1 where a gap is closed, 0 where nothing touches, 1 where triangles cross.
void show_contacts(FrameInput& frame, const Simulation& simulation, const State& state,
                   const Eigen::VectorXf&) {
    const Model& model = simulation.model();
    const Contact contact(model, simulation.obstacles(), Vec3::Zero(), state, 0);
    Eigen::VectorXf tint = (contact.gap_shares(state.x, state.time).array() - 1).matrix().cast<float>();
    Surfaces surfaces(model, simulation.obstacles());
    const std::vector<bool> crosses = crossing_vertices(surfaces, state);
    for (Eigen::Index v = 0; v < tint.size(); ++v)
        if (crosses[static_cast<size_t>(v)]) tint[v] = 1;
    for (const Cloth& cloth : model.cloths)
        frame.tint.emplace_back(tint.segment(cloth.first, cloth.vertices()));
}

void show_springs(FrameInput& frame, const Simulation& simulation, const State& state,
                  const Eigen::VectorXf&) {
    const std::vector<Cloth>& cloths = simulation.model().cloths;
    Segments& segments = frame.segments;
    size_t count = 0;
    for (const Cloth& cloth : cloths) count += cloth.network.edges.size() + cloth.network.bends.size();
    segments.ends.resize(3, static_cast<Eigen::Index>(2 * count));
    for (const Cloth& cloth : cloths) {
        for (const auto* springs : {&cloth.network.edges, &cloth.network.bends}) {
            for (const Spring& spring : *springs) {
                const Vec3 a = state.x.col(cloth.first + spring.a);
                const Vec3 b = state.x.col(cloth.first + spring.b);
                const auto s = static_cast<Eigen::Index>(segments.colour.size());
                segments.ends.col(2 * s) = a;
                segments.ends.col(2 * s + 1) = b;
                const double strain = spring.rest_length > 0 ? (b - a).norm() / spring.rest_length - 1 : 0;
                segments.colour.push_back(diverging_colour(static_cast<float>(strain) / strain_range));
            }
        }
    }
}

}  // namespace

const OverlayKind& overlay_named(std::string_view name) {
    static const std::array kinds{
        OverlayKind{"none", Overlay::none, {}, leave_empty},
        OverlayKind{"wire", Overlay::wire, {}, leave_empty},
        OverlayKind{
            "strain", Overlay::tint, {"strain", {"-5 %", "0", "+5 %"}, diverging_colour}, show_strain},
        OverlayKind{"springs", Overlay::springs, {}, show_springs},
        OverlayKind{"error", Overlay::tint, {"error mm", {"0.001", "0.3", "100"}, rising_colour}, show_error},
        OverlayKind{"contacts",
                    Overlay::tint,
                    {"contact", {"pressed", "free", "crosses"}, diverging_colour},
                    show_contacts}};
    return find_named(kinds, "overlay", name);
}

}  // namespace drape
