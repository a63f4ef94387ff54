// What a frame brought, as bytes of a checkpoint.
#pragma once

#include <vector>

#include "simulate/simulation.h"

namespace drape {

void put_frames(ByteWriter& out, const std::vector<FrameReport>& frames);

// Fewer than were put where the bytes end before.
std::vector<FrameReport> take_frames(ByteReader& in);

}  // namespace drape
