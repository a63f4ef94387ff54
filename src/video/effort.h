// What a video may give up so that its file stays small.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace drape {

struct Effort {
    double scale;      // of width and height
    double most_rate;  // frames a second that are shown
    int quality;       // of 100, for a format that has it
    double share;      // of the first one's bytes, as measured on the demo scenes, about
};

// From all that a file can be to hardly enough. Each needs less room than the one before.
std::span<const Effort> efforts();

// After `tried` made a file of `bytes`: the first that is likely to fit into `most`, at the least the next;
// efforts().size() where there is none.
std::size_t next_effort(std::size_t tried, std::uint64_t bytes, std::uint64_t most);

}  // namespace drape
