// Budgets: the pacer against a clock that the test turns, deliveries only where no speed of the machine
// changes what they must do.
#include <catch2/catch.hpp>
#include <numeric>

#include "base/timer.h"
#include "simulate/delivery.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

// A run of `frames` frames whose steps cost `step_seconds(frame)` and whose pictures cost `picture`.
template <class StepSeconds>
double spent(double budget, int frames, double picture, double spare, StepSeconds step_seconds) {
    double now = 0;
    Pacer pacer({budget, [&] { return now; }}, frames, step_seconds(0));
    for (int k = 0; k < frames; ++k) {
        pacer.begin_frame();
        const double steps = std::max(1.0, std::floor(pacer.affordable_steps(k == 0 ? spare : 0)));
        now += steps * step_seconds(k);
        pacer.end_frame(steps);
        now += picture;
    }
    return now;
}

struct Delivered {
    std::string method, how;
    std::vector<std::string> hashes;
    std::vector<long> steps;
    double error = NAN;
    size_t passes = 0;
    long all_steps() const { return std::accumulate(steps.begin(), steps.end(), 0L); }
};

Delivered delivered(const Setup& setup, const DeliveryOptions& options) {
    const auto delivery = make_delivery(setup, options);
    Delivered all;
    while (delivery->frame() < setup.frames) {
        const auto frame = delivery->advance();
        REQUIRE(frame);
        REQUIRE(frame->trouble.empty());
        all.hashes.push_back(frame->hash);
        all.steps.push_back(frame->planned_steps);
    }
    all.method = delivery->simulation().method().name;
    all.how = delivery->error().how;
    all.error = delivery->error().rms;
    all.passes = delivery->error().passes.size();
    return all;
}

// CPU seconds, which other loads of the machine do not take away
DeliveryOptions within(double seconds) {
    return {.budget =
                Budget{seconds, [began = process_cpu_seconds()] { return process_cpu_seconds() - began; }}};
}

}  // namespace

TEST_CASE("the pacer spends its budget to a few per cent, whatever pictures and contact cost", "[simulate]") {
    const auto even = [](int) { return 1e-3; };
    CHECK(spent(10, 100, 0, 0, even) == Approx(9.7).epsilon(0.01));
    CHECK(spent(10, 100, 0.05, 0.5, even) == Approx(9.7).epsilon(0.02));
    CHECK(spent(10, 5, 0.5, 0.5, even) == Approx(9.7).epsilon(0.06));
    // steps that cost three times as much from the middle on
    CHECK(spent(10, 100, 0.01, 0, [](int k) { return k < 50 ? 1e-3 : 3e-3; }) == Approx(9.7).epsilon(0.02));
    // a first guess that was ten times too low
    CHECK(spent(10, 100, 0, 0, [](int k) { return k == 0 ? 1e-4 : 1e-3; }) == Approx(9.7).epsilon(0.03));
}

TEST_CASE("a longer budget buys more steps, and every one of them is known afterwards", "[simulate]") {
    for (const Setup& setup : {flag(), ball_drop()}) {
        const Delivered little = delivered(setup, within(1)), much = delivered(setup, within(4));
        CHECK(much.all_steps() > little.all_steps());
        CHECK(much.error < little.error);
        Setup again = setup;
        again.method = much.method;
        const Delivered replayed = delivered(again, {.replay = much.steps});
        CHECK(replayed.hashes == much.hashes);
        CHECK(replayed.steps == much.steps);
        CHECK(replayed.error == much.error);
    }
}

TEST_CASE("a budget with no time for stable explicit steps takes longer ones of projections", "[simulate]") {
    const Delivered hasty = delivered(swatch(16, 1e6), within(1e-3));
    CHECK(hasty.method == "xpbd");
    CHECK(hasty.passes == 2);
    for (const long steps : hasty.steps) CHECK(steps == 1);
    Setup fixed = swatch(16, 1e6);
    fixed.method = "verlet";
    const Delivered alone = delivered(fixed, within(1e-3));
    CHECK(alone.passes == 1);
    CHECK(alone.how.find("no time") != std::string::npos);
    CHECK(std::isnan(alone.error));
    // never beyond stability
    CHECK(static_cast<double>(alone.steps.front()) >= 0.05 / Simulation(fixed).longest_step());
}

TEST_CASE("a run within a budget goes on where it was stopped", "[simulate]") {
    const Setup setup = flag();
    const auto first = make_delivery(setup, within(2));
    for (int k = 0; k < 4; ++k) REQUIRE(first->advance());
    const auto later = make_delivery(setup, within(2));
    REQUIRE(later->restore(first->save()));
    CHECK(later->frame() == 4);
    CHECK(later->state().x == first->state().x);
    while (later->frame() < setup.frames) REQUIRE(later->advance()->trouble.empty());
    CHECK(later->error().rms > 0);
    CHECK_FALSE(make_delivery(setup, within(2))->restore("no such bytes"));
}
