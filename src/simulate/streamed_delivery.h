// The default way to run a scene: one pass whose frames are delivered as they come, and beside it a companion
// with some fewer steps. Richardson's rule makes the distance between the two an estimate of the error.
#pragma once

#include "simulate/delivery.h"
#include "simulate/error_estimate.h"

namespace drape {

class StreamedDelivery final : public Delivery {
public:
    StreamedDelivery(Setup setup, const DeliveryOptions& options);

    std::optional<FrameReport> advance() override;
    const Simulation& simulation() const override { return *delivered_; }
    const State& state() const override { return delivered_->state(); }
    int frame() const override { return delivered_->frame(); }
    const Eigen::VectorXf& vertex_error() const override { return vertex_error_; }
    const ErrorAccount& error() const override { return account_; }
    PassProgress progress() const override { return {}; }
    // Frames from now on take so many steps, the companion's fewer.
    void pace(double steps);

    std::string save() const override;
    bool restore(std::string_view bytes) override;

private:
    void drop_companion(std::string why);
    void judge(FrameReport& delivered, const FrameReport& companion);

    int threads_;
    std::vector<long> replay_;  // planned steps of every frame; empty: as they come
    std::unique_ptr<Simulation> delivered_, companion_;
    double steps_ = 0, companion_steps_ = 0;
    double mean_edge_ = 0;  // [m]
    bool jumps_ = false;    // forces did: contact was met, or the cloth is made so
    bool parted_ = false;   // the passes' folds fell differently
    Eigen::VectorXf vertex_error_;
    ErrorAccount account_;
};

}  // namespace drape
