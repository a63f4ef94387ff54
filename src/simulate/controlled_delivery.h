// Runs a scene to a tolerance: whole passes with ever more steps, compared at the output frames, until the
// worst frame's error is below what was asked. Only then are frames delivered. Local step errors are no
// guide: they misjudge the error of a frame by orders of magnitude.
//
// Where no method is asked for, up to three ways are tried (ways.h): a rough one if it promises the tolerance
// for less, the usual explicit one, and one of higher order where the usual one would have to refine much.
// Each starts a row of passes of its own; only passes of one row are compared.
//
// A twin of a row's first pass, its start moved by 1e-12 m, shows the predictability floor: how far two runs
// end apart that no measurement could tell apart at the start. Frames whose floor lies above the tolerance
// are delivered as the others came out.
#pragma once

#include "simulate/delivery.h"
#include "simulate/error_estimate.h"
#include "simulate/ways.h"

namespace drape {

// Positions at every frame of one pass, and what the frames brought.
struct Pass {
    double refine = 1;  // Setup::refine
    std::vector<Points> x;
    std::vector<FrameReport> frames;
    double steps = 0;
    bool jumps = false;  // forces did: contact was met, or the cloth is made so
};

class ControlledDelivery final : public Delivery {
public:
    ControlledDelivery(Setup setup, const DeliveryOptions& options);

    std::optional<FrameReport> advance() override;
    const Simulation& simulation() const override { return *running_; }
    const State& state() const override { return shown_; }
    int frame() const override { return delivered_; }
    const Eigen::VectorXf& vertex_error() const override { return vertex_error_; }
    const ErrorAccount& error() const override { return account_; }
    PassProgress progress() const override;
    std::string save() const override;
    bool restore(std::string_view bytes) override;

private:
    void start_row(int row);
    void start_pass(double refine);
    void start_twin();
    void run_frame();
    void end_pass();
    void keep_pass();  // the next ones are compared with it
    void note_floor();
    void judge();
    // the row to go on with when the next pass of this one must refine so much
    int better_row(double refine) const;
    void accept(bool reached);
    const Way& way() const { return rows_[static_cast<size_t>(row_)]; }
    double order_here(bool jumps) const;                 // of the passes that run
    double worst_distance(bool above_floor_only) const;  // of any frame [m]
    FrameReport deliver();

    Setup setup_;
    int threads_, frames_;
    double tolerance_, mean_edge_;  // [m]
    std::vector<Way> rows_;
    int row_ = 0, usual_row_ = 0;
    std::unique_ptr<Simulation> running_, twin_;
    Pass before_, now_;
    size_t before_record_ = 0;          // of before_, among account_.passes
    std::vector<double> floor_;         // per frame [m]
    std::vector<ErrorNorms> distance_;  // of now_ from before_, per frame
    // of the row's passes, newest last
    std::vector<double> row_steps_, row_distance_;
    double share_ = NAN;  // of the distance that is now_'s error
    int idle_ = 0, failed_ = 0;
    bool accepted_ = false;
    int delivered_ = 0;
    State shown_;
    Eigen::VectorXf vertex_error_;
    ErrorAccount account_;
};

}  // namespace drape
