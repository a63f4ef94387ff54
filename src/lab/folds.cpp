// Notes: cloth of a regular mesh folds along the mesh's lines, that of an irregular one in curves.
#include "lab/folds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/numbers.h"
#include "lab/elastic.h"
#include "lab/equilibrium.h"
#include "lab/kinds.h"
#include "lab/plot.h"
#include "mesh/curvature.h"
#include "mesh/pattern.h"
#include "study/csv.h"
#include "study/plot_style.h"

namespace drape {

namespace {

using std::numbers::pi;

constexpr double diameter = 0.4, shrunk = 0.04;  // of the disc [m], and of its border [-]
constexpr double noise = 1e-4;                   // out of the plane at the start [m]
constexpr double still = 1e-5;                   // [m]
constexpr double inner = 0.8;                    // share of the radius within which vertices count
constexpr double near_line = 15 * pi / 180;      // [rad]
constexpr int folded_divisions = 16, starts = 3;

// Springs as the notes have them, and hinges that let a fold be some edges wide.
Fabric folding_fabric() {
    Fabric fabric;
    fabric.density = 0.15;
    fabric.stretch_model = StretchModel::force_per_strain;
    fabric.stretch = 1;
    fabric.altitude = AltitudeMode::blend;
    fabric.bending_kind = BendingKind::hinge;
    fabric.bending = 3e-4;
    return fabric;
}

// Directions of lines, 0 to pi, lie at most a quarter turn apart.
double between(double one, double other) {
    const double apart = std::abs(one - other);
    return std::min(apart, pi - apart);
}

double direction_of(const Vec3& along) {
    const double angle = std::atan2(along.z(), along.x());
    return angle < 0 ? angle + pi : angle;
}

struct Fold {
    double direction = 0, strength = 0;  // [rad], [m]: curvature times area
    double near_lines = 0;               // how much of all directions is as near to the vertex's edges
    bool on_line = false;
};

std::vector<Fold> folds_of(const Cloth& cloth, const Points& x) {
    const Mesh& mesh = cloth.mesh;
    const std::vector<Mat3> tensors = curvature_tensors(cloth.topology, mesh.faces, mesh.rest, x);
    std::vector<std::vector<double>> lines(tensors.size());
    for (const Edge& edge : cloth.topology.edges)
        for (const int v : edge.vertex)
            lines[static_cast<size_t>(v)].push_back(
                direction_of(mesh.rest.col(edge.vertex[1]) - mesh.rest.col(edge.vertex[0])));
    std::vector<Fold> folds(tensors.size());
    for (size_t v = 0; v < tensors.size(); ++v) {
        if (mesh.rest.col(static_cast<Eigen::Index>(v)).norm() > inner * diameter / 2) continue;
        const Eigen::SelfAdjointEigenSolver<Mat3> axes(tensors[v]);
        const int sharpest = -axes.eigenvalues()[0] > axes.eigenvalues()[2] ? 0 : 2;
        Fold& fold = folds[v];
        fold.direction = direction_of(axes.eigenvectors().col(sharpest));
        fold.strength = std::abs(axes.eigenvalues()[sharpest]) * cloth.mass[static_cast<Eigen::Index>(v)] /
                        cloth.fabric.density;
        // how much of the circle is near a line, on half-degree marks
        const auto is_near = [&](double direction) {
            return std::any_of(lines[v].begin(), lines[v].end(),
                               [&](double line) { return between(line, direction) < near_line; });
        };
        constexpr int marks = 360;
        for (int i = 0; i < marks; ++i) fold.near_lines += is_near((i + 0.5) * pi / marks) ? 1.0 / marks : 0;
        fold.on_line = is_near(fold.direction);
    }
    return folds;
}

Points buckled(const Model& free, std::uint64_t seed) {
    const Cloth& cloth = free.cloths.front();
    Model held = free;
    PinGroup pins;
    pins.vertices = cloth.topology.boundary_loops.front();
    pins.anchors = (1 - shrunk) * cloth.mesh.rest(Eigen::all, pins.vertices);
    Points start = (1 - shrunk) * cloth.mesh.rest;
    std::mt19937_64 random(seed);
    for (Eigen::Index v = 0; v < start.cols(); ++v)
        start(1, v) = noise * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    for (const int v : pins.vertices) start.col(v) = (1 - shrunk) * cloth.mesh.rest.col(v);
    add_pins(held, std::move(pins));
    return come_to_rest(held, Vec3::Zero(), start, still).x;
}

LabFigure rose_figure(const std::vector<FoldRose>& roses) {
    PanelGrid grid{static_cast<int>(roses.size()), 1, 210, 210};
    grid.left = 24, grid.right = 24, grid.across = 24, grid.bottom = 30, grid.top = 78;
    LabFigure figure{"folds",
                     "Where a disc that is pressed together all round folds: how much of its folding lies in "
                     "each direction, by mesh pattern. The grey circle is a sheet that prefers none.",
                     grid.width(),
                     grid.height(),
                     "",
                     grid.begin("Directions of folds") +
                         "set size ratio -1\nunset border\nunset tics\nunset key\nset parametric\n"
                         "set trange [0:2*pi]\n"};
    double reach = 1;
    for (const FoldRose& rose : roses) reach = std::max(reach, rose.most());
    for (size_t i = 0; i < roses.size(); ++i) {
        std::vector<std::array<double, 2>> outline;
        for (int k = 0; k <= 2 * fold_bins; ++k) {
            const double share = roses[i].share[static_cast<size_t>(k % fold_bins)];
            for (const double edge : {-0.5, 0.5}) {
                const double angle = (k + edge) * pi / fold_bins;
                outline.push_back({share * std::cos(angle), share * std::sin(angle)});
            }
        }
        figure.data += data_block(cat("r", i), outline);
        figure.plot +=
            cat("set title ", plot_quoted(roses[i].pattern), " noenhanced font ',12' offset 0,-0.5\n",
                "set xrange [", -1.05 * reach, ":", 1.05 * reach, "]\nset yrange [", -1.05 * reach, ":",
                1.05 * reach, "]\nplot $r", i, " using 1:2 with filledcurves closed fc rgb '", plot_colour(i),
                "' fs solid 0.35, $r", i, " using 1:2 with lines lw 1.6 lc rgb '", plot_colour(i),
                "', cos(t),sin(t) with lines lw 1.4 lc rgb '#888888'\n");
    }
    figure.plot += "unset multiplot\n";
    return figure;
}

std::string rose_csv(const std::vector<FoldRose>& roses) {
    std::string text = "pattern,direction_deg,share_over_even\n";
    for (const FoldRose& rose : roses)
        for (int k = 0; k < fold_bins; ++k)
            text += cat(rose.pattern, ",", 180.0 * k / fold_bins, ",",
                        csv_number(rose.share[static_cast<size_t>(k)]), "\n");
    return text;
}

}  // namespace

double FoldRose::most() const {
    return *std::max_element(share.begin(), share.end());
}

double FoldRose::most_deg() const {
    return 180.0 * static_cast<double>(std::max_element(share.begin(), share.end()) - share.begin()) /
           fold_bins;
}

FoldRose fold_directions(std::string_view pattern, int count, int all) {
    FoldRose rose{std::string(pattern), std::vector<double>(fold_bins, 0)};
    double sum = 0, even = 0, on_lines = 0, turn = 0, turning = 0;
    for (int start = 1; start <= all; ++start) {
        PatternSize size{diameter, diameter, count, count, static_cast<std::uint64_t>(start)};
        size.over = "disc";
        const Model free = free_cloth(make_pattern(pattern, size), folding_fabric());
        const Cloth& cloth = free.cloths.front();
        const std::vector<Fold> folds = folds_of(cloth, buckled(free, static_cast<std::uint64_t>(start)));
        for (const Fold& fold : folds) {
            const auto bin = static_cast<size_t>(std::lround(fold.direction / pi * fold_bins)) % fold_bins;
            rose.share[bin] += fold.strength;
            sum += fold.strength;
            on_lines += fold.on_line ? fold.strength : 0;
            even += fold.near_lines * fold.strength;
        }
        // along an edge that a fold runs on, from a vertex to the next
        for (const Edge& edge : cloth.topology.edges) {
            const Fold &one = folds[static_cast<size_t>(edge.vertex[0])],
                       &other = folds[static_cast<size_t>(edge.vertex[1])];
            const double weight = std::min(one.strength, other.strength);
            turn += weight * between(one.direction, other.direction) * 180 / pi;
            turning += weight;
        }
    }
    for (double& share : rose.share) share *= fold_bins / sum;
    rose.along_lines = on_lines / even;
    rose.turn_deg = turn / turning;
    return rose;
}

LabResult run_folds() {
    std::vector<FoldRose> roses;
    for (const std::string& pattern : even_patterns())
        roses.push_back(fold_directions(pattern, folded_divisions, starts));
    LabResult result;
    result.claim =
        "of the folding of a disc pressed together all round, the most in one direction over the mean:";
    LabTable table{{"pattern", "most in one direction, over the mean", "at [degrees]",
                    "within 15 degrees of an edge, over chance", "turns from vertex to vertex [degrees]"},
                   {},
                   1};
    for (const FoldRose& rose : roses) {
        result.claim +=
            cat(result.claim.ends_with(':') ? " " : ", ", rose.pattern, " ", figure(rose.most(), 3));
        table.rows.push_back({rose.pattern, figure(rose.most(), 3), figure(rose.most_deg()),
                              figure(rose.along_lines, 3), figure(rose.turn_deg, 3)});
    }
    result.story = {
        "A disc whose border is held and moved inwards by 4 % must fold, and nothing but its mesh says in "
        "which "
        "direction. Springs are as the notes have them, all alike in force per strain, with a little "
        "bending. "
        "Where the sheet came to rest, each vertex's curvature counts towards the direction of the fold line "
        "it lies on.",
        "Where diagonals meet in one vertex in eight and pass by the next, as on alternating and crossed "
        "meshes, "
        "folds keep to the mesh's lines and turn sharply from one to another. One_way triangles, all alike, "
        "prefer "
        "a direction less, equilateral and irregular ones none to speak of: there folds curve."};
    result.figures = {rose_figure(roses)};
    result.tables = {table};
    result.csv = {{"folds", rose_csv(roses)}};
    return result;
}

}  // namespace drape
