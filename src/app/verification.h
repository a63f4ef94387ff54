// Whether a run repeats an earlier one, frame by frame, by the hashes of that one's report.json.
#pragma once

#include <string>
#include <vector>

#include "simulate/simulation.h"

namespace drape {

class Verification {
public:
    // Throws Error where the file is no report of a run of `scene` with all of the frames 1 to `last`.
    Verification(const std::string& path, const std::string& scene, int last);

    // Each throws Error (Exit::different) "frame 7: ..." that names the stage, where the bits are others.
    void positions(const FrameReport& frame) const;
    // `hashes` of the pictures from frame 1 on, "" for one that is not drawn; goes on from the last one seen.
    void pictures(const std::vector<std::string>& hashes);

    std::string summary(int frames) const;  // of a run that passed

private:
    std::string path_;
    std::vector<std::string> positions_, pictures_;  // hashes of frame 1, 2, ...; "": there was no picture
    size_t seen_ = 0;                                // pictures
    int compared_ = 0;                               // of them
};

}  // namespace drape
