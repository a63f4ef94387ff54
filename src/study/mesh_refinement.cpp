#include "study/mesh_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"
#include "scene/builder.h"
#include "simulate/predicted_cost.h"
#include "study/measure.h"

namespace drape {

namespace {

constexpr std::array factors{0.5, 1.0, 2.0};
constexpr double least_order = 0.8, most_order = 4;  // of meshes that converge

std::string why_not(const SceneDescription& scene) {
    for (size_t c = 0; c < scene.cloths.size(); ++c) {
        const ClothDescription& cloth = scene.cloths[c];
        if (!cloth.mesh.empty())
            return cat("cloth ", c + 1, " is a mesh file; refining the mesh needs a pattern");
        if (!find_named(pattern_kinds(), "pattern", cloth.pattern).on_grid)
            return cat("cloth ", c + 1, " is ", cloth.pattern,
                       ", whose finer meshes do not share vertices with it");
        if (!cloth.start.mesh.empty())
            return cat("cloth ", c + 1, " starts from a mesh file, which has one set of divisions");
    }
    return "";
}

bool divisible(const SceneDescription& scene, double factor) {
    return std::all_of(scene.cloths.begin(), scene.cloths.end(), [&](const ClothDescription& cloth) {
        const double columns = factor * cloth.pattern_size.columns, rows = factor * cloth.pattern_size.rows;
        return columns >= 1 && rows >= 1 && columns == std::floor(columns) && rows == std::floor(rows);
    });
}

SceneDescription refined(SceneDescription scene, double factor) {
    for (ClothDescription& cloth : scene.cloths) {
        PatternSize& size = cloth.pattern_size;
        size.columns = static_cast<int>(std::lround(factor * size.columns));
        size.rows = static_cast<int>(std::lround(factor * size.rows));
    }
    return scene;
}

// The vertices that the mesh `stride` times coarser also has, cloth after cloth; patterns run row by row.
Points common_vertices(const SceneDescription& scene, const Model& model, In x, int stride) {
    std::vector<Eigen::Index> common;
    for (size_t c = 0; c < scene.cloths.size(); ++c) {
        const PatternSize& size = scene.cloths[c].pattern_size;
        const std::vector<int>& vertex = model.cloths[c].mesh.file_vertex;
        for (int row = 0; row <= size.rows; row += stride)
            for (int column = 0; column <= size.columns; column += stride)
                common.push_back(model.cloths[c].first +
                                 vertex[static_cast<size_t>(row * (size.columns + 1) + column)]);
    }
    return x(Eigen::all, common);
}

// Distances from the finest of three meshes, each of half the edge of the one before, in their ratio
// (4^p - 1) / (2^p - 1) = 2^p + 1.
void estimate(MeshRefinement& refinement, const std::vector<RefinedMesh*>& run) {
    const auto own =
        std::find_if(run.begin(), run.end(), [](const RefinedMesh* mesh) { return mesh->factor == 1; });
    if (own == run.end() || *own == run.back()) return;
    if (own != run.begin()) {
        const double ratio = (*std::prev(own))->last.rms / (*own)->last.rms;
        refinement.order = std::min(std::log2(std::max(ratio - 1, 1.0)), most_order);
        refinement.order_seen = true;
        refinement.converges = refinement.order >= least_order;
    }
    const double gain = std::pow(2, refinement.order);
    refinement.error = (*own)->last.rms * (refinement.converges ? gain / (gain - 1) : 1);
}

// What is left to spend [CPU s], and what a predicted second was last found to take.
struct Allowance {
    double left = 0, calibration = 1;
};

// Positions of common vertices at every frame go to `x`. A mesh that cannot be run says why, and no more.
RefinedMesh run_mesh(const SceneDescription& scene, double factor, int stride, int frames,
                     Allowance& allowance, std::vector<Points>& x) {
    RefinedMesh mesh;
    mesh.factor = factor;
    if (!divisible(scene, factor)) {
        mesh.left_out = "its divisions are odd";
        return mesh;
    }
    const SceneDescription description = refined(scene, factor);
    try {
        Setup setup = build_scene(description).setup;
        setup.frames = frames;
        setup.method.clear();
        setup.step.reset();
        mesh.vertices = setup.model.vertices();
        const double predicted = predicted_cost(Simulation(setup)).seconds;
        if (allowance.calibration * predicted > allowance.left) {
            mesh.left_out = cat("would cost about ", figure(allowance.calibration * predicted), " CPU s");
            return mesh;
        }
        const MeasuredPass pass = measure_pass(setup, INFINITY, [&](const State& state) {
            x.push_back(common_vertices(description, setup.model, state.x, stride));
        });
        mesh.cpu_seconds = pass.cpu_seconds;
        mesh.left_out = pass.trouble;
        allowance.left -= pass.cpu_seconds;
        allowance.calibration = pass.cpu_seconds / predicted;
    } catch (const Error& error) {
        // a pin that holds no vertex of a coarser mesh
        mesh.left_out = error.what();
    }
    return mesh;
}

}  // namespace

MeshRefinement refine_mesh(const SceneDescription& scene, int frames, double most_cpu,
                           const std::function<void(const std::string&)>& say) {
    MeshRefinement refinement;
    refinement.refused = why_not(scene);
    if (!refinement.refused.empty()) return refinement;
    for (const ClothDescription& cloth : scene.cloths)
        if (cloth.fabric.stretch_model != StretchModel::membrane)
            refinement.note =
                "The fabric is given per spring, so that each mesh is another cloth: give it as a "
                "membrane to judge the mesh alone.";
    std::vector<std::vector<Points>> positions;
    Allowance allowance{most_cpu};
    double coarsest = 0;
    for (const double factor : factors) {
        std::vector<Points> x;
        const double stride = coarsest == 0 ? 1 : factor / coarsest;
        const RefinedMesh mesh = run_mesh(scene, factor, static_cast<int>(stride), frames, allowance, x);
        say(cat("mesh x ", factor, ": ",
                mesh.left_out.empty() ? cat(figure(mesh.cpu_seconds), " CPU s") : mesh.left_out));
        if (mesh.left_out.empty()) {
            positions.push_back(std::move(x));
            if (coarsest == 0) coarsest = factor;
        }
        refinement.meshes.push_back(mesh);
    }
    std::vector<RefinedMesh*> run;
    for (RefinedMesh& mesh : refinement.meshes)
        if (mesh.left_out.empty()) run.push_back(&mesh);
    for (size_t i = 0; i + 1 < run.size(); ++i) {
        for (size_t k = 0; k < positions[i].size(); ++k) {
            run[i]->last = distance_between(positions[i][k], positions.back()[k]);
            run[i]->worst_rms = std::max(run[i]->worst_rms, run[i]->last.rms);
        }
    }
    estimate(refinement, run);
    return refinement;
}

}  // namespace drape
