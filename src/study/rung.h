// One method with one step: a dot of the plot, a row of the tables.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/picture_difference.h"
#include "integrate/method.h"
#include "simulate/error_estimate.h"
#include "study/measure.h"

namespace drape {

// As reported: never below the reference's error bar, so never 0.
struct RungErrors {
    double final_rms = NAN, final_max = NAN;  // at the last frame [m]
    double time_l2 = NAN;                     // root mean square over frames and vertices [m]
    bool below_bar = false;                   // the last frame's RMS: the true value is anywhere below
};

struct Rung {
    const Method* method = nullptr;
    int steps_a_frame = 0;
    double step = 0;               // [s]
    double predicted_cpu = 0;      // [s]
    std::string left_out, failed;  // why; "" = neither

    MeasuredPass pass;
    std::vector<double> cpu, wall;     // of each repeat [s]
    std::vector<ErrorNorms> distance;  // from the reference, per frame [m]
    RungErrors errors;
    std::optional<PictureDifference> picture;

    bool good() const { return left_out.empty() && failed.empty(); }
};

double median(std::vector<double> values);

// What is reported of distances from a reference with this bar.
RungErrors reported_errors(const std::vector<ErrorNorms>& distance, const std::vector<ErrorNorms>& bar);

}  // namespace drape
