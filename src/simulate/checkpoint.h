// A run's last good state in a file's bytes: what --resume goes on from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.h"

namespace drape {

struct Checkpoint {
    std::uint64_t scene_hash = 0;  // of the effective scene: another scene's checkpoint is no start
    int frame = 0;
    State state;
    EnergyFlow flow;
    double start_energy = 0;  // [J]
};

std::string checkpoint_bytes(const Checkpoint& checkpoint);

// Nothing if the bytes are not a whole checkpoint of this version.
std::optional<Checkpoint> read_checkpoint(std::string_view bytes);

}  // namespace drape
