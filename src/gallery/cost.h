// What a run came to, from its report.json.
#pragma once

#include <optional>
#include <string>

namespace drape {

struct Cost {
    std::string scene, method;
    int vertices = 0, frames = 0;
    std::optional<double> step;      // [s]
    std::optional<double> error;     // RMS of the worst frame, as estimated [m]
    double cpu = 0, simulation = 0;  // of all; of the steps of the delivered run alone [CPU s]
    double memory = 0;               // at most [MB]
};

// Throws Error where the file is no report of a run.
Cost read_cost(const std::string& path);

}  // namespace drape
