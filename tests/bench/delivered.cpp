#include "bench/delivered.h"

#include <algorithm>

#include "base/timer.h"

namespace drape::bench {

namespace {

// what the error cost besides the passes that are not delivered
double twin_seconds(const ErrorAccount& error) {
    double hidden = 0;
    for (size_t i = 0; i + 1 < error.passes.size(); ++i) hidden += error.passes[i].cpu_seconds;
    return std::max(0.0, error.seconds - hidden);
}

}  // namespace

Delivered deliver(const Setup& setup, const DeliveryOptions& options) {
    const double began = thread_cpu_seconds();
    Delivered run;
    const auto delivery = make_delivery(setup, options);
    while (delivery->frame() < setup.frames) {
        const auto frame = delivery->advance();
        if (!frame) continue;
        run.trouble = frame->trouble;
        if (!run.trouble.empty()) break;
        run.x.push_back(delivery->state().x);
        run.stated.push_back(frame->error_rms);
    }
    run.error = delivery->error();
    run.method = delivery->simulation().method().name;
    // without a tolerance there is no twin
    run.twin = options.tolerance ? twin_seconds(run.error) : 0;
    run.cpu = thread_cpu_seconds() - began - run.twin;
    return run;
}

}  // namespace drape::bench
