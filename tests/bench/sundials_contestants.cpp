#include <array>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"
#include "bench/sundials_solvers.h"

namespace drape::bench {

namespace {

struct Solver {
    const char* name;
    SundialsRun* run;
};
constexpr std::array solvers{
    Solver{"SUNDIALS ERK 3(2)", run_bogacki_shampine}, Solver{"SUNDIALS ERK 5(4)", run_dormand_prince},
    Solver{"SUNDIALS ERK 8(7)", run_fehlberg_8},       Solver{"SUNDIALS Adams", run_adams},
    Solver{"SUNDIALS BDF, KLU", run_bdf_direct},       Solver{"SUNDIALS BDF, GMRES", run_bdf_krylov},
};
constexpr double loosest = 1e-3, tightest = 1e-10;
constexpr int rungs_a_decade = 2;

}  // namespace

std::vector<Contestant> sundials_contestants(const SpringSystem& system, double time) {
    std::vector<Contestant> contestants;
    for (const Solver& solver : solvers) {
        Contestant contestant{.name = solver.name};
        const int rungs = static_cast<int>(std::lround(rungs_a_decade * std::log10(loosest / tightest)));
        for (int rung = 0; rung <= rungs; ++rung) {
            const double tolerance = loosest * std::pow(10, -double(rung) / rungs_a_decade);
            contestant.entries.push_back({.setting = "tolerance " + figure(tolerance, 2),
                                          .run = [&system, time, run = solver.run, tolerance](double most) {
                                              return run(system, time, tolerance, most);
                                          }});
        }
        contestants.push_back(std::move(contestant));
    }
    return contestants;
}

}  // namespace drape::bench
