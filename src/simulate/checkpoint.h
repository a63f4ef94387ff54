// A run's last good state in a file's bytes: what --resume goes on from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace drape {

struct Checkpoint {
    std::uint64_t scene_hash = 0;  // of the effective scene: another scene's checkpoint is no start
    double start_energy = 0;       // [J]
    std::string passes;            // what Delivery::save() gave
};

std::string checkpoint_bytes(const Checkpoint& checkpoint);

// Nothing if the bytes are not a whole checkpoint of this version.
std::optional<Checkpoint> read_checkpoint(std::string_view bytes);

}  // namespace drape
