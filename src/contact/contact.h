// All contact of a scene: every cloth with every obstacle, and cloth with cloth where asked. Skips what
// cannot be reached: points join a pair's list only when motion could bring them into contact before the next
// look. Obstacles that are meshes meet cloth as cloth does (self_contact.h).
#pragma once

#include <memory>
#include <vector>

#include "contact/obstacle_contact.h"

namespace drape {

class SelfContact;

class Contact {
public:
    // `start` and `duration` tell how fast cloth may meet each obstacle; the model must outlive this.
    Contact(const Model& model, const std::vector<Obstacle>& obstacles, const Vec3& gravity,
            const State& start, double duration);
    ~Contact();

    // Before a step from `state` of at most h: makes sure that every point it can bring into contact is
    // listed.
    void prepare(const State& state, double h);

    // The same for a step that may take vertices `way` [m] from x, by `time` or from it.
    void cover(In x, double time, double way);

    double energy(In x, double time) const;
    void add_conservative(In x, double time, Out f) const;
    ObstacleContact::Result add_all(In x, In v, double time, Out f,
                                    NormalDamping damping = NormalDamping::force);
    // for implicit methods, as in ObstacleContact
    void add_couplings(Couplings& couplings) const;
    void add_stiffness(In x, In v, double time, BlockMatrix& k) const;
    void add_damping(In x, In v, double time, BlockMatrix& b) const;
    void add_majorant(In x, In v, double time, double c, Eigen::VectorXd& diagonal) const;

    // as in ObstacleContact; x must be covered for the whole move
    double clear_part(In x, In move, double time) const;

    // Whether a step from one state to the other led cloth through an obstacle, which neither of them shows.
    bool passed_through(const State& before, const State& after);

    ContactWork rub(Points& v, double h) const;
    double least_distance(In x, double time, bool held = true) const;  // as in ObstacleContact

    // Pairs of triangles that cross, of surfaces that meet by pairs (mesh/crossings.h).
    int crossings(In x, double time) const;

    // Per column of the State (gap_shares.cpp): the least gap that contact works across at the vertex or in
    // the triangles around it, of the gap where it begins; 1: nothing touches there.
    Eigen::VectorXd gap_shares(In x, double time) const;

    // Clears small overlaps of the start (see ObstacleContact::lift_out). Returns the largest move [m];
    // throws Error where that leaves cloth in an obstacle, or in cloth.
    double lift_out(Points& x) const;

    double thickness() const { return thickness_; }  // of the thickest barrier [m]
    const std::vector<ObstacleContact>& pairs() const { return pairs_; }
    const SelfContact* self() const { return self_.get(); }  // null: no cloth meets cloth or a mesh
    // Changes where add_couplings would couple other vertices at x than before.
    long couplings_version(In x, double time) const;

private:
    const Model& model_;
    std::vector<ObstacleContact> pairs_;
    std::unique_ptr<SelfContact> self_;
    double obstacle_speed_ = 0;  // of any obstacle's surface near the cloth at most [m/s]
    double thickness_ = 0;       // largest of all barriers [m]
    Points gathered_at_;         // where the lists were made
    double gathered_time_ = 0;
    double way_ = -1;  // how far motion may go before they are made again [m]; < 0: not made yet
};

}  // namespace drape
