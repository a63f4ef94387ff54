// Projective dynamics: backward Euler, solved by rounds with one constant matrix that is factored once per
// step size. With A = M / h^2 + the majorants of every force (cloth/majorant.h), which bounds the Hessian of
// the step's Phi (implicit_stage.h) as far as the forces' own bounds hold, a round is
//   x += A^-1 (-grad Phi(x)),   the three coordinates apart.
// For springs that is a local and a global step in turn: with p = l0 n, a spring's vector at its rest length,
// c (x_i - x_j - p) is its force, so that the minimum over x of |x - y|^2_M / (2 h^2) + sum c/2 |x_i - x_j -
// p|^2 at fixed p is where the round leads. Liu, Bouaziz and Kavan (Quasi-Newton Methods for Real-time
// Simulation of Hyperelastic Materials, 2017) see in it a quasi-Newton method and speed it up by L-BFGS, as
// is done here: the last moves and what they changed of the gradient correct A, which is far too stiff across
// springs. The number of rounds still grows as h omega.
//
// Contact and friction are no constant: each vertex has its present share of them on the diagonal, and A is
// factored again at the start of a solve, and when that leaves a factor of two.
#include <cmath>
#include <deque>

#include "integrate/kinds.h"
#include "integrate/majorant_matrix.h"
#include "integrate/staged_integrator.h"

namespace drape {

namespace {

double dot(const Points& a, const Points& b) {
    return a.cwiseProduct(b).sum();
}

// The last moves and what they changed of the residual: what they tell of the inverse Hessian.
class Memory {
public:
    void clear() { pairs_.clear(); }
    bool is_empty() const { return pairs_.empty(); }
    void keep(Points move, Points change) {
        const double curvature = dot(move, change);
        // along a line of no or negative curvature there is no inverse to learn
        if (!(curvature > 1e-10 * move.norm() * change.norm())) return;
        if (pairs_.size() == most_pairs) pairs_.pop_front();
        pairs_.push_back({std::move(move), std::move(change), curvature, 0});
    }
    // The inverse Hessian times the residual, `base` standing for the inverse of A: the two-loop recursion.
    template <class Base>
    Points direction(Points residual, Base base) {
        for (auto pair = pairs_.rbegin(); pair != pairs_.rend(); ++pair) {
            pair->part = dot(pair->move, residual) / pair->curvature;
            residual -= pair->part * pair->change;
        }
        Points way = base(residual);
        for (const Pair& pair : pairs_)
            way += (pair.part - dot(pair.change, way) / pair.curvature) * pair.move;
        return way;
    }

private:
    static constexpr size_t most_pairs = 5;
    struct Pair {
        Points move, change;
        double curvature;  // move . change
        double part;       // scratch of direction()
    };
    std::deque<Pair> pairs_;
};

class ProjectiveSolver final : public StageSolver {
public:
    explicit ProjectiveSolver(Dynamics& dynamics) : StageSolver(dynamics), matrix_(dynamics) {}

    SolverWork work() const override { return {matrix_.factorisations(), rounds_}; }

private:
    void begin(const ImplicitStage&) override {}
    Outcome improve(const ImplicitStage& stage, int round) override;
    int most_rounds() const override { return 1000; }
    bool leap(const ImplicitStage&, double, int) override { return false; }
    bool is_done(const ImplicitStage& stage) const;

    MajorantMatrix matrix_;
    Memory memory_;
    Eigen::VectorXd contact_;
    std::vector<double> drops_;  // of Phi, summed over the first rounds; from 0 on [J]
    long rounds_ = 0;
};

// In the norm |.|_M / h a solution is off by no more than the root of twice what Phi can still fall. What
// that is, the last quarter of the rounds tells, whose number grows with the stiffness: whether it made less
// of it than three thousandths of the forces' own share in the step, of which backward Euler errs by a half.
// A step that a thousand rounds do not bring there has failed: to keep it would let springs of 1e9 N/m gain
// energy.
bool ProjectiveSolver::is_done(const ImplicitStage& stage) const {
    constexpr double part = 0.003, harmless = 1e-8;  // of the forces' share; an error that never matters [m]
    const double scale = dynamics_.kinetic_energy(now_.v - stage.vp);
    const double floor = dynamics_.model().mass.sum() / 2 * std::pow(harmless / stage.c, 2);
    const size_t rounds = drops_.size() - 1, last = std::max<size_t>(10, rounds / 4);
    return rounds >= last && drops_[rounds] - drops_[rounds - last] <= part * part * scale + floor;
}

StageSolver::Outcome ProjectiveSolver::improve(const ImplicitStage& stage, int round) {
    if (is_settled(stage)) return Outcome::converged;
    ++rounds_;
    contact_.setZero(now_.x.cols());
    dynamics_.add_contact_majorant(now_.x, now_.v, stage.time, stage.c, contact_);
    if (round == 0) {
        // from nothing that an earlier step has left: a run that was stopped must go on the same
        memory_.clear();
        drops_.assign(1, 0);
        matrix_.factorise(stage.c, contact_);
    } else {
        matrix_.follow(stage.c, contact_);
    }
    const Points way =
        memory_.direction(now_.residual, [&](const Points& right) { return matrix_.solve(right); });
    const double move = largest_move(way);
    if (!std::isfinite(move)) return Outcome::stuck;
    double length = 0;
    if (!search(stage, way, length)) {
        if (move < coarse_move(stage)) return Outcome::converged;
        if (memory_.is_empty()) return Outcome::stuck;
        memory_.clear();
        return Outcome::moved;
    }
    // the search has left in next_ what was now_
    memory_.keep(now_.x - next_.x, next_.residual - now_.residual);
    drops_.push_back(drops_.back() - rise(next_, now_));
    return is_done(stage) ? Outcome::converged : Outcome::moved;
}

}  // namespace

std::unique_ptr<Integrator> make_projective_dynamics() {
    return make_backward_euler_with([](Dynamics& dynamics) -> std::unique_ptr<StageSolver> {
        return std::make_unique<ProjectiveSolver>(dynamics);
    });
}

}  // namespace drape
