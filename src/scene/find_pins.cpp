#include "scene/find_pins.h"

#include "base/error.h"

namespace drape {

namespace {

[[noreturn]] void no_match(const PinDescription& pin, const std::string& why) {
    throw Error(cat(pin.place.text, ": pin matches nothing: ", why));
}

double mean_edge(const Cloth& cloth) {
    double sum = 0;
    for (const Spring& edge : cloth.network.edges) sum += edge.rest_length;
    return sum / static_cast<double>(cloth.network.edges.size());
}

int nearest_vertex(const PinDescription& pin, const Cloth& cloth) {
    Eigen::Index nearest = 0;
    const double distance =
        std::sqrt((cloth.mesh.rest.colwise() - *pin.near).colwise().squaredNorm().minCoeff(&nearest));
    const double within = pin.within.value_or(mean_edge(cloth));
    if (distance > within)
        no_match(pin, cat("the nearest vertex is ", distance, " m away (at most ", within,
                          " m; `within` sets it)"));
    return static_cast<int>(nearest);
}

std::vector<int> matching_vertices(const PinDescription& pin, const Cloth& cloth) {
    if (pin.near) return {nearest_vertex(pin, cloth)};
    if (pin.boundary) {
        const auto& loops = cloth.topology.boundary_loops;
        if (*pin.boundary >= static_cast<int>(loops.size()))
            no_match(pin, cat("there is no boundary ", *pin.boundary, " (the cloth has ", loops.size(),
                              ", counted from 0)"));
        return loops[static_cast<size_t>(*pin.boundary)];
    }
    const Eigen::AlignedBox3d box((*pin.box)[0].cwiseMin((*pin.box)[1]),
                                  (*pin.box)[0].cwiseMax((*pin.box)[1]));
    std::vector<int> inside;
    for (int v = 0; v < cloth.vertices(); ++v)
        if (box.contains(Vec3(cloth.mesh.rest.col(v)))) inside.push_back(v);
    if (inside.empty()) {
        const Vec3 low = cloth.mesh.rest.rowwise().minCoeff(), high = cloth.mesh.rest.rowwise().maxCoeff();
        no_match(pin, cat("no vertex is in the box (the cloth reaches from [", low.x(), ", ", low.y(), ", ",
                          low.z(), "] to [", high.x(), ", ", high.y(), ", ", high.z(), "])"));
    }
    return inside;
}

}  // namespace

PinGroup find_pins(const PinDescription& pin, const Cloth& cloth, In start) {
    PinGroup group;
    group.vertices = matching_vertices(pin, cloth);
    group.anchors.resize(3, static_cast<Eigen::Index>(group.vertices.size()));
    for (size_t i = 0; i < group.vertices.size(); ++i) {
        group.vertices[i] += cloth.first;
        group.anchors.col(static_cast<Eigen::Index>(i)) = start.col(group.vertices[i]);
    }
    group.about = pin.about.value_or(group.anchors.rowwise().mean());
    group.motion = RigidMotion(pin.motion);
    group.rigid = pin.rigid;
    for (const Keyframe& key : pin.motion)
        if (!pin.rigid && key.rotate_deg != Vec3::Zero())
            throw Error(pin.place.text +
                        ": rotate_deg turns a group of pins only as one body (set rigid = true)");
    return group;
}

}  // namespace drape
