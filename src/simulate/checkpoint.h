// A run's last good state in a file's bytes: what --resume goes on from.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.h"

namespace drape {

struct Checkpoint {
    std::string scene;                // the effective one's text: another scene's checkpoint is no start
    std::string steps;                // what else the frames follow from: the method, steps that are repeated
    double start_energy = 0;          // [J]
    SolverWork solver;                // so far
    std::vector<FrameReport> frames;  // delivered so far
    std::vector<std::string> pictures;  // hashes of these frames' pictures; "": none was drawn
    bool keeps_positions = false;       // of these frames, in a file beside it
    std::string passes;                 // what Delivery::save() gave
};

std::string checkpoint_bytes(const Checkpoint& checkpoint);

// Nothing if the bytes are not a whole checkpoint of this version.
std::optional<Checkpoint> read_checkpoint(std::string_view bytes);

}  // namespace drape
