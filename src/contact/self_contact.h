// Contact of cloth with itself, with other cloths and with meshes: barrier force, normal damping, Coulomb
// friction.
//
// The potential is a sum over pairs (self_pair.h), its barrier as thick as the fabric: layers lie on each
// other a thickness apart. Normal damping and friction are those of an obstacle (obstacle_contact.h), between
// the nearest points of a pair. Meshes are surfaces like cloths, whose vertices nothing but their motion
// moves.
//
// Two lists keep what is looked at few. Those pairs that motion may bring into contact soon are `near`,
// chosen from those that it may bring there at all, which a search (self_search.h) finds. Both hold until
// motion since (drift.h) could have brought another pair into contact. So every evaluation sees every pair in
// contact, in one order, and no result depends on when the lists were made.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "cloth/block_matrix.h"
#include "contact/drift.h"
#include "contact/layers.h"
#include "contact/obstacle_contact.h"
#include "contact/self_search.h"
#include "contact/surfaces.h"
#include "mesh/crossings.h"

namespace drape {

class SelfContact {
public:
    // null if no cloth of the model meets cloth, and no obstacle is a mesh; of others it knows nothing. How
    // fast surfaces may meet is told by what follows; the model must outlive this.
    static std::unique_ptr<SelfContact> make(const Model& model, const std::vector<Obstacle>& obstacles,
                                             const Vec3& gravity, const State& start, double duration);

    // Evaluations from now on are steps of h apart: pairs that one may bring into contact are listed, so that
    // they can shorten it.
    void prepare(double h);

    double energy(In x, double time);
    void add_conservative(In x, double time, Out f);
    // as in ObstacleContact
    ObstacleContact::Result add_all(In x, In v, double time, Out f,
                                    NormalDamping damping = NormalDamping::force);

    // For implicit methods, as in ObstacleContact. Which vertices are coupled changes with x, and then the
    // version (self_contact_matrices.cpp).
    long couplings_version(In x, double time);
    void add_couplings(Couplings& couplings) const;
    void add_stiffness(In x, In v, double time, BlockMatrix& k);
    void add_damping(In x, In v, double time, BlockMatrix& b);

    ContactWork rub(Points& v, double h) const;
    void list_grips(std::vector<Grip>& grips) const;

    // How much of `move` from x (at most 1) keeps every pair apart, by a tenth of its distance at least, and
    // no farther than some edges apart from its neighbours.
    double clear_part(In x, In move, double time);
    // Whether cloth went through cloth or a mesh on the straight way from one to the other.
    bool passed_through(const State& before, const State& after);

    // Throws Error where triangles cross, or touch so nearly that no force could part them.
    void demand_apart(In x);
    // of triangles that are to meet; a mesh may cross itself and others
    Crossings crossings(In x, double time);
    // The least distance of cloth from any mesh, as far as that is near; else infinite. As in
    // ObstacleContact.
    double least_distance(In x, double time, bool held);

    // Per column of the State: the least distance of its triangles from others, of those that are nearer than
    // `reach` and that contact keeps apart; else infinite [m].
    Eigen::VectorXd room(In x, double time, double reach);
    void lower_gap_shares(In x, double time, Eigen::VectorXd& shares);  // as Contact::gap_shares
    // Adds to `move` what takes pairs at x that are nearer than a share of their barrier straight apart to
    // it, in the mean of a vertex's pairs. The least share that any is apart, or infinite (untangle.cpp).
    double push_apart(In x, double share, Points& move);
    double mean_edge() const { return search_.mean_edge(); }  // [m]

    const Surfaces& surfaces() const { return surfaces_; }
    Eigen::Ref<const Points> positions(In x, double time) { return surfaces_.positions(x, time); }
    const Faces& faces() const { return faces_; }  // columns of those positions
    // of two cloths, or of a cloth and a mesh, numbered after the cloths
    const Barrier& barrier(int surface, int other) const;

private:
    struct Touch {
        SelfPair pair;
        Nearest nearest;
        double normal_force;  // [N]
        double stiffness;     // [N/m]
        double damping;       // [N s/m]
        double fading;        // stiffness of its fading potential [N/m]
    };
    SelfContact(Surfaces surfaces, std::vector<Layers> layers, const std::vector<double>& thickness);

    const Layers& layers(const SelfPair& pair) const { return layers_[static_cast<size_t>(pair.layers)]; }
    double damping_of(const Layers& layers, double stiffness) const;
    // lists pairs that may touch at x, and on a way from there that changes distances by up to `more`
    void cover(In x, double more);
    // ... and that may close in within the next step
    void cover(In x, In v);
    void list(In x, double drift);
    bool found_hold(In x) const;                     // and will while near_ does
    bool touches_mesh(const SelfPair& pair) const {  // the vertices of a mesh are the last
        return std::max(pair.vertex[0], pair.vertex[3]) >= surfaces_.columns();
    }
    static Nearest measure(SelfPair& pair, const PairPoints& at);
    void limit_modes(ContactLimits& limits);
    double clear_part(const SelfPair& pair, const PairPoints& at, const PairPoints& way, double most) const;
    template <class Visit>
    void each_press(In x, In v, double time, Visit visit);
    void add_element(const SelfPair& pair, const PairMatrix& value, BlockMatrix& matrix) const;

    Surfaces surfaces_;
    std::vector<int> surface_;    // of each of faces_
    Faces faces_;                 // of all surfaces that meet any
    std::vector<Layers> layers_;  // by layers_of
    SelfSearch search_;
    double thickness_;  // of the thickest barrier [m]
    double ahead_ = 0;  // [s]

    std::vector<SelfPair> found_, near_;
    Drift found_drift_, near_drift_;  // since those were listed
    double found_margin_ = -1;        // drift that found_ holds for [m]; < 0: nothing found yet
    double near_margin_ = -1;
    long version_ = 0;

    std::vector<Touch> touches_;
    NormalDamping damping_ = NormalDamping::force;  // of touches_
    Eigen::Matrix2Xd rows_;                         // of stiffness and damping; zero but within add_all
};

}  // namespace drape
