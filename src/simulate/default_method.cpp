#include "simulate/default_method.h"

#include "base/error.h"
#include "simulate/predicted_cost.h"
#include "simulate/simulation.h"

namespace drape {

MethodChoice explicit_choice(const Dynamics& dynamics) {
    if (dynamics.is_conservative())
        return {"takahashi_imada",
                "energy is conserved, so Takahashi-Imada has order four at two sweeps a step"};
    return {"verlet", "damping, drag or contact leave every method at order two, and one sweep is cheapest"};
}

void Simulation::choose_method() {
    const auto [method, because] = explicit_choice(*dynamics_);
    take_method(method, because);
    if (setup_.step) {
        if (*setup_.step > longest_)
            take_method(
                *setup_.step > far_beyond * longest_ ? bounded_choice : implicit_choice,
                cat("the step asked for is beyond the longest stable one of ", method, ", ", longest_, " s"));
        return;
    }
    const Method& implicit = method_named(implicit_choice);
    const double ratio =
        predicted_cost(*this).seconds / predicted_cost(*this, implicit, usual_step(implicit)).seconds;
    if (ratio > explicit_worth)
        take_method(implicit.name,
                    cat("so stiff that ", method, " is predicted to cost ", ratio, " times as much"));
}

}  // namespace drape
