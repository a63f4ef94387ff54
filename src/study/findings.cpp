#include "study/findings.h"

#include <algorithm>
#include <cmath>

namespace drape {

namespace {

constexpr double clear_of_bar = 3;  // times the bar: below, the reference's own error bends the slope
constexpr size_t most_rungs = 4;    // the shortest steps: longer ones are not yet on the slope

}  // namespace

const Rung* cheapest_under(const Study& study, double metres) {
    const Rung* best = nullptr;
    for (const Rung& rung : study.rungs)
        if (rung.good() && rung.errors.final_rms <= metres && (!best || median(rung.cpu) < median(best->cpu)))
            best = &rung;
    return best;
}

const Rung* representative(const Study& study, const Method& method, double metres) {
    const Rung *cheapest = nullptr, *finest = nullptr;
    for (const Rung* rung : study.rungs_of(method)) {
        if (!finest || rung->errors.final_rms < finest->errors.final_rms) finest = rung;
        if (rung->errors.final_rms <= metres && (!cheapest || median(rung->cpu) < median(cheapest->cpu)))
            cheapest = rung;
    }
    return cheapest ? cheapest : finest;
}

SeenOrder seen_order(const Study& study, const Method& method) {
    SeenOrder order;
    order.expected = method.order_where(study.probe.conservative, false);
    std::vector<const Rung*> rungs;
    for (const Rung* rung : study.rungs_of(method))
        if (rung->errors.final_rms > clear_of_bar * study.bar()) rungs.push_back(rung);
    if (rungs.size() > most_rungs) rungs.erase(rungs.begin(), rungs.end() - most_rungs);
    order.rungs = static_cast<int>(rungs.size());
    if (rungs.size() < 2) return order;
    // least squares
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const Rung* rung : rungs) {
        const double h = std::log(rung->step), e = std::log(rung->errors.final_rms);
        x += h;
        y += e;
        xx += h * h;
        xy += h * e;
    }
    const auto n = static_cast<double>(rungs.size());
    order.seen = (n * xy - x * y) / (n * xx - x * x);
    return order;
}

}  // namespace drape
