#include "bench/plain_verlet.h"

#include "base/error.h"

namespace drape::bench {

Points run_plain_verlet(const SpringSystem& system, double time, int steps) {
    const double h = time / steps;
    std::vector<double> x = system.x, v = system.v, a(x.size());
    accelerate(system, x.data(), a.data());
    for (size_t i = 0; i < v.size(); ++i) v[i] += 0.5 * h * a[i];
    for (int step = 0; step < steps; ++step) {
        for (size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
        accelerate(system, x.data(), a.data());
        // the closing half kick and the next step's opening one; velocities at the end are not asked for
        for (size_t i = 0; i < v.size(); ++i) v[i] += h * a[i];
    }
    return as_points(x);
}

Contestant plain_verlet(const SpringSystem& system, double time, double fewest) {
    Contestant contestant{.name = "plain scalar Verlet loop", .order = 2};
    for (const int steps : steps_ladder(fewest))
        contestant.entries.push_back({.setting = cat(steps, " steps"), .run = [&system, time, steps](double) {
                                          return Outcome{.x = run_plain_verlet(system, time, steps)};
                                      }});
    return contestant;
}

}  // namespace drape::bench
