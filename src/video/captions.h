// What is written under the frames of a sequence.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "picture/caption.h"

namespace drape {

struct Captions {
    Caption common;                                      // of every frame
    std::map<int, std::vector<std::string>> facts = {};  // more of some, by their number

    Caption of(int frame) const;
};

// What a run's report.json says: the captions, and at what rate its frames were made.
struct ReportedRun {
    Captions captions;      // scene, method, step, CPU time a frame; and of every frame its time and error
    double frame_rate = 0;  // [1/s]; 0: the report has no frame
};

// Throws Error where the file is no report of a run. What it does not know is left out.
ReportedRun read_reported_run(const std::string& path);

}  // namespace drape
