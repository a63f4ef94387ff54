// Which pieces of surfaces are near each other: every vertex and triangle, and every two edges, that share no
// vertex and are nearer than a reach.
//
// Triangles are sorted into the cells of a uniform grid that their boxes touch. Of two triangles whose boxes
// meet, each vertex and edge is looked at by one triangle alone that owns it (Curtis, Tamstorf and Manocha's
// representative triangles), and in the one cell that holds the lowest corner of what both boxes share, so
// that no pair comes twice. Pieces of one part that are near each other at rest, nearer than twice the
// barrier's thickness, can do nothing about it and are left out; that goes by rest distance and not by
// neighbours, so that a fine mesh's barrier is not forever at work.
#pragma once

#include <cstdint>
#include <vector>

#include "cloth/model.h"
#include "contact/layers.h"
#include "contact/near_tests.h"
#include "contact/self_pair.h"

namespace drape {

class SelfSearch {
public:
    // `thickness`: of the barriers, by layers_of; negative where two do not meet [m]. The last `meshes` of
    // the model's cloths are obstacles.
    SelfSearch(const Model& model, std::vector<double> thickness, int meshes = 0);

    // Replaces `pairs` by those nearer than `reach`, in an order that depends on nothing but which they are.
    void find(In x, double reach, std::vector<SelfPair>& pairs);

    bool is_empty() const { return faces_.empty(); }
    double mean_edge() const { return mean_edge_; }  // of cloth at rest [m]

private:
    struct Face {
        int vertex[3];
        int first_edge, edges;  // of owned_edges_
        int owned;              // bits of the corners that it owns
        int cloth;
    };
    struct Box {
        double low[3], high[3];
    };
    struct Entry {
        std::uint64_t cell;
        int face;
    };

    void number_faces(const Model& model);
    bool make_boxes(In x, double margin);  // false where positions are not finite
    void fill_grid();
    template <class Visit>
    void each_cell(const Box& box, Visit visit) const;
    std::uint64_t cell_of(const double* at) const;
    bool meet(int cloth, int other) const {
        return thickness_[static_cast<size_t>(layers_of(cloth, other, cloths_))] > 0;
    }
    void look_into(size_t bucket);  // adds the candidates of its triangles
    void add_vertices(const Face& face, const Face& other);
    void add_edges(const Face& face, const Face& other);
    void sift(In x, double reach, std::vector<SelfPair>& pairs);  // appends those candidates that are near
    bool is_mesh(int vertex) const { return cloth_[static_cast<size_t>(vertex)] >= first_mesh_; }
    double vertex_area(const int* vertex) const;  // A of a pair
    double edges_area(const Candidate& edges) const;
    void keep_if_near(In x, SelfPair pair, double reach, std::vector<SelfPair>& pairs) const;

    std::vector<Face> faces_;
    std::vector<std::array<int, 2>> owned_edges_;  // vertices, lower first
    std::vector<double> edge_area_;                // of each of them [m^2]
    Points rest_;
    std::vector<int> cloth_, part_;  // of each vertex; parts are numbered through
    Eigen::VectorXd area_, inverse_mass_;
    std::vector<double> thickness_;
    int cloths_ = 0, first_mesh_ = 0;
    double mean_edge_ = 0;

    // scratch
    std::vector<Box> boxes_;
    BoxList bucket_boxes_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_;
    std::vector<Candidate> vertex_candidates_, edge_candidates_;
    std::vector<std::uint32_t> first_;  // of each bucket's entries
    std::vector<Entry> entries_;
    double cell_ = 1, origin_[3] = {};
};

}  // namespace drape
