#include "study/study_csv.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "study/csv.h"

namespace drape {

namespace {

std::string row(const Rung& rung) {
    std::string text = cat(rung.method->name, ",", rung.steps_a_frame, ",", csv_number(rung.step), ",",
                           rung.good()           ? "ok"
                           : rung.failed.empty() ? "left out"
                                                 : "failed",
                           ",");
    const bool ran = rung.good();
    const auto value = [&](double v) { text += (ran ? csv_number(v) : "") + ","; };
    const auto count = [&](long n) { text += (ran ? std::to_string(n) : "") + ","; };
    value(rung.errors.final_rms);
    value(rung.errors.final_max);
    value(rung.errors.time_l2);
    count(rung.errors.below_bar ? 1 : 0);
    value(rung.pass.energy_drift);
    value(rung.picture ? rung.picture->mean_levels : NAN);
    value(rung.picture ? rung.picture->share_over : NAN);
    value(median(rung.cpu));
    value(rung.cpu.empty() ? NAN : *std::min_element(rung.cpu.begin(), rung.cpu.end()));
    value(rung.cpu.empty() ? NAN : *std::max_element(rung.cpu.begin(), rung.cpu.end()));
    value(median(rung.wall));
    count(static_cast<long>(rung.cpu.size()));
    count(rung.pass.steps);
    count(rung.pass.sweeps);
    count(rung.pass.solver.factorisations);
    count(rung.pass.solver.iterations);
    return text + csv_number(rung.predicted_cpu) + "," + csv_text(rung.failed + rung.left_out) + "\n";
}

}  // namespace

std::string study_csv(const Study& study) {
    std::string text =
        "method,steps_a_frame,step_s,status,final_rms_m,final_max_m,time_l2_m,below_bar,energy_drift_j,"
        "picture_mean_levels,picture_share_over_8,cpu_s,cpu_min_s,cpu_max_s,wall_s,repeats,steps,sweeps,"
        "factorisations,iterations,predicted_cpu_s,why\n";
    for (const Rung& rung : study.rungs) text += row(rung);
    return text;
}

}  // namespace drape
