// Runs a scene within a budget of wall seconds: the steps of every frame are as many as are affordable. What
// the clock said is in every frame's planned_steps, and a run that is given these (DeliveryOptions::replay)
// repeats the bits.
#pragma once

#include "simulate/pacer.h"
#include "simulate/streamed_delivery.h"
#include "simulate/ways.h"

namespace drape {

// How the budget is to be spent.
struct Approach {
    Way way;
    bool estimate = true;     // beside the delivered pass
    double step_seconds = 0;  // wall, of a step of all passes [s]
};

class BudgetedDelivery final : public Delivery {
public:
    BudgetedDelivery(Setup setup, const DeliveryOptions& options);

    std::optional<FrameReport> advance() override;
    const Simulation& simulation() const override { return inner_->simulation(); }
    const State& state() const override { return inner_->state(); }
    int frame() const override { return inner_->frame(); }
    const Eigen::VectorXf& vertex_error() const override { return inner_->vertex_error(); }
    const ErrorAccount& error() const override { return inner_->error(); }
    PassProgress progress() const override { return {}; }
    double spent_before() const override { return before_; }
    std::string save() const override;
    bool restore(std::string_view bytes) override;

private:
    void take(const Approach& approach);

    Setup setup_;
    DeliveryOptions options_;
    int frames_;
    Approach approach_;
    double before_ = 0;  // spent by a run that this one goes on from [s]
    double most_steps_ = 0;
    bool waits_for_contact_ = false;  // which will cost more than what came before it
    std::optional<Pacer> pacer_;
    std::unique_ptr<StreamedDelivery> inner_;
};

}  // namespace drape
