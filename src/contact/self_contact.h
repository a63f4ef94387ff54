// Contact of cloth with itself and with other cloths: barrier force, normal damping, Coulomb friction.
//
// The potential is a sum over pairs (self_pair.h), its barrier as thick as the fabric: layers lie on each
// other a thickness apart. Normal damping and friction are those of an obstacle (obstacle_contact.h), between
// the nearest points of a pair.
//
// Two lists keep what is looked at few. Those pairs that motion may bring into contact soon are `near`,
// chosen from those that it may bring there at all, which a search (self_search.h) finds. Both hold until
// motion since (drift.h) could have brought another pair into contact. So every evaluation sees every pair in
// contact, in one order, and no result depends on when the lists were made.
#pragma once

#include <memory>
#include <vector>

#include "cloth/block_matrix.h"
#include "contact/drift.h"
#include "contact/obstacle_contact.h"
#include "contact/self_search.h"
#include "mesh/crossings.h"

namespace drape {

class SelfContact {
public:
    // null if no cloth of the model meets cloth. `start` and `gravity` tell how fast cloth may meet cloth;
    // the model must outlive this.
    static std::unique_ptr<SelfContact> make(const Model& model, const Vec3& gravity, const State& start);

    // Evaluations from now on are steps of h apart: pairs that one may bring into contact are listed, so that
    // they can shorten it.
    void prepare(double h);

    double energy(In x);
    void add_conservative(In x, Out f);
    // as in ObstacleContact
    ObstacleContact::Result add_all(In x, In v, Out f, NormalDamping damping = NormalDamping::force);

    // For implicit methods, as in ObstacleContact. Which vertices are coupled changes with x, and then the
    // version (self_contact_matrices.cpp).
    long couplings_version(In x);
    void add_couplings(Couplings& couplings) const;
    void add_stiffness(In x, In v, BlockMatrix& k);
    void add_damping(In x, In v, BlockMatrix& b);

    ContactWork rub(Points& v, double h) const;
    void list_grips(std::vector<Grip>& grips) const;

    // How much of `move` from x (at most 1) keeps every pair apart, by a tenth of its distance at least, and
    // no farther than some edges apart from its neighbours.
    double clear_part(In x, In move);
    // Whether cloth went through cloth on its straight way from one to the other.
    bool passed_through(In before, In after);

    // Throws Error where triangles cross, or touch so nearly that no force could part them.
    void demand_apart(In x);
    Crossings crossings(In x) const { return count_crossings(faces_, x); }

    const Barrier& barrier(int cloth, int other) const;

private:
    struct Layers {  // two cloths, or one with itself
        Barrier barrier;
        double density;   // of both together, as far as their relative motion goes [kg/m^2]
        double friction;  // [-]
    };
    struct Touch {
        SelfPair pair;
        Nearest nearest;
        double normal_force;  // [N]
        double stiffness;     // [N/m]
        double damping;       // [N s/m]
        double fading;        // stiffness of its fading potential [N/m]
    };
    SelfContact(const Model& model, std::vector<Layers> layers, const std::vector<double>& thickness,
                std::vector<std::pair<int, int>> ranges);

    const Layers& layers(const SelfPair& pair) const { return layers_[static_cast<size_t>(pair.layers)]; }
    double damping_of(const Layers& layers, double stiffness) const;
    // lists pairs that may touch at x, and on a way from there that changes distances by up to `more`
    void cover(In x, double more);
    // ... and that may close in within the next step
    void cover(In x, In v);
    void list(In x, double drift);
    bool found_hold(In x) const;  // and will while near_ does
    static Nearest measure(SelfPair& pair, const PairPoints& at);
    void limit_modes(ContactLimits& limits);
    double clear_part(const SelfPair& pair, const PairPoints& at, const PairPoints& way, double most) const;
    template <class Visit>
    void each_press(In x, In v, Visit visit);

    const Model& model_;
    Faces faces_;                 // of the cloths that meet cloth, columns of the State
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
