// The surfaces that may meet each other: cloths, and obstacles that are meshes. Their vertices are numbered
// as one: the columns of the State, then those of each mesh, which go where its motion takes them.
#pragma once

#include <optional>
#include <vector>

#include "cloth/model.h"
#include "obstacle/obstacle.h"

namespace drape {

class Surfaces {
public:
    // Of those obstacles that are meshes; others are no concern of this. The model must outlive this.
    Surfaces(const Model& cloths, const std::vector<Obstacle>& obstacles);

    // Cloths, then meshes as cloths that no force moves; self_contact where one meets anything.
    const Model& model() const { return with_meshes_ ? *with_meshes_ : cloths_; }
    int count() const { return static_cast<int>(model().cloths.size()); }
    int meshes() const { return static_cast<int>(meshes_.size()); }
    int columns() const { return cloths_.vertices(); }  // of the State
    const Obstacle* mesh(int surface) const;            // null: a cloth
    bool meet(int surface, int other) const;

    // All vertices where those of cloth are at x, or move by v, or by `move` while meshes stand still. What
    // is given out holds until the same is asked again.
    Eigen::Ref<const Points> positions(In x, double time);
    Eigen::Ref<const Points> velocities(In v, double time);
    Eigen::Ref<const Points> moves(In move);

    // of a vertex; a mesh's where velocities were last asked for
    Vec3 velocity(In v, int vertex) const {
        return vertex < columns() ? v.col(vertex) : mesh_velocity(vertex);
    }
    Vec3 mesh_velocity(int vertex) const { return v_.col(vertex); }

private:
    void place_meshes(double time);

    const Model& cloths_;
    std::vector<Obstacle> meshes_;
    std::optional<Model> with_meshes_;  // none: no meshes
    Points x_, v_, move_;
    std::optional<double> time_;  // that meshes are placed for
};

}  // namespace drape
