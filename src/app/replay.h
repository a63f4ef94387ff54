// What a report says of how its run was stepped, so that another run can repeat the bits.
#pragma once

#include <string>
#include <vector>

namespace drape {

struct Replay {
    std::string scene, method;
    std::vector<long> steps;          // planned, of every frame
    std::vector<std::string> hashes;  // of the positions, of every frame
};

// Throws Error where the file is no report of a run.
Replay read_replay(const std::string& path);

}  // namespace drape
