#include "study/collapse.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/error.h"
#include "base/names.h"
#include "mesh/pattern.h"
#include "scene/fabric_words.h"
#include "simulate/simulation.h"

namespace drape {

namespace {

constexpr int divisions = 6, across = divisions + 1;
constexpr double out_of_place = 1.5 / divisions, little = 0.02 / divisions;  // [m], of a sheet of 1 m
constexpr double collapsed_below = 0.1, recovered_above = 0.5;               // of the rest area
constexpr double frame_rate = 10, seconds = 2;

Fabric fabric_with(AltitudeMode mode) {
    Fabric fabric;
    fabric.density = 0.2;
    fabric.stretch_model = StretchModel::spring_constant;
    fabric.stretch = 100;
    fabric.altitude = mode;
    fabric.damping = 0.1;
    return fabric;
}

Setup sheet(AltitudeMode mode, Collapse collapse, int trial) {
    const Mesh mesh = make_pattern("alternating", {1, 1, divisions, divisions});
    Setup setup;
    setup.world.gravity.setZero();
    setup.frame_rate = frame_rate;
    setup.frames = static_cast<int>(seconds * frame_rate);
    setup.start.x = mesh.rest;
    setup.start.v = Points::Zero(3, mesh.rest.cols());
    add_cloth(setup.model, make_cloth(mesh, fabric_with(mode)));
    std::mt19937 random(static_cast<unsigned>(trial) + 1);
    const bool squashed = collapse == Collapse::squashed;
    const auto shift = [&] {
        return (squashed ? little : out_of_place) *
               (2.0 * double(random()) / double(std::mt19937::max()) - 1);
    };
    if (squashed) setup.start.x.row(2) *= 0.02;
    PinGroup border;
    for (int i = 0; i < across * across; ++i) {
        const int row = i / across, column = i % across;
        if (!squashed && (std::min(row, column) == 0 || std::max(row, column) == divisions)) {
            border.vertices.push_back(i);
            continue;
        }
        const double along = shift(), up = shift(), aside = shift();
        setup.start.x.col(i) += Vec3(along, collapse == Collapse::thrown_in_space ? up : 0, aside);
    }
    border.anchors = mesh.rest(Eigen::all, border.vertices);
    if (!squashed) add_pins(setup.model, std::move(border));
    return setup;
}

// Of each triangle, over its rest area.
Eigen::VectorXd signed_areas(const Mesh& mesh, In x) {
    Eigen::VectorXd areas(mesh.faces.cols());
    for (Eigen::Index f = 0; f < areas.size(); ++f) {
        const int a = mesh.faces(0, f), b = mesh.faces(1, f), c = mesh.faces(2, f);
        const Vec3 rest = (mesh.rest.col(b) - mesh.rest.col(a)).cross(mesh.rest.col(c) - mesh.rest.col(a));
        const Vec3 now = (x.col(b) - x.col(a)).cross(x.col(c) - x.col(a));
        areas[f] = now.dot(rest) / rest.squaredNorm();
    }
    return areas;
}

Recovery recovery_of(AltitudeMode mode, Collapse collapse, int trials) {
    Recovery recovery{.mode = mode, .start = collapse};
    for (int trial = 0; trial < trials; ++trial) {
        Simulation simulation(sheet(mode, collapse, trial));
        const Mesh& mesh = simulation.model().cloths[0].mesh;
        const Eigen::VectorXd before = signed_areas(mesh, simulation.state().x);
        bool good = true;
        while (good && simulation.frame() < simulation.frames()) good = simulation.advance().trouble.empty();
        recovery.stopped += !good;
        const Eigen::VectorXd after = signed_areas(mesh, simulation.state().x);
        for (Eigen::Index f = 0; f < before.size(); ++f) {
            if (!(before[f] < collapsed_below)) continue;
            ++recovery.collapsed;
            if (good && after[f] > recovered_above) ++recovery.recovered;
        }
    }
    return recovery;
}

}  // namespace

std::string_view name_of(Collapse collapse) {
    return collapse_kinds[static_cast<size_t>(collapse)].name;
}

std::vector<Recovery> measure_recovery(int trials, const std::function<bool()>& stop) {
    std::vector<Recovery> recoveries;
    for (const CollapseKind& kind : collapse_kinds)
        for (const auto& word : altitude_words)
            if (!stop()) recoveries.push_back(recovery_of(word.choice, kind.collapse, trials));
    return recoveries;
}

std::vector<std::string> recovery_summary(const std::vector<Recovery>& recoveries) {
    std::vector<std::string> lines;
    if (recoveries.empty()) return lines;
    for (const CollapseKind& kind : collapse_kinds) {
        std::vector<std::string> shares;
        for (const Recovery& r : recoveries)
            if (r.start == kind.collapse)
                shares.push_back(cat(word_for(altitude_words, r.mode), " ",
                                     std::lround(100.0 * r.recovered / r.collapsed), " %",
                                     r.stopped > 0 ? cat(" (", r.stopped, " runs stopped)") : ""));
        lines.push_back(cat("collapsed triangles that come back, ", kind.name, ": ", joined(shares)));
    }
    return lines;
}

std::string recovery_csv(const std::vector<Recovery>& recoveries) {
    std::string text = "altitude,start,collapsed,recovered,runs_stopped\n";
    for (const Recovery& r : recoveries)
        text += cat(word_for(altitude_words, r.mode), ",", name_of(r.start), ",", r.collapsed, ",",
                    r.recovered, ",", r.stopped, "\n");
    return text;
}

}  // namespace drape
