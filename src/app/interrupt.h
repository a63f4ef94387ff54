// Ctrl-C and SIGTERM ask a run to stop after the frame in hand, or within it if that takes longer than a few
// seconds; a second one stops at once.
#pragma once

namespace drape {

void catch_interrupts();
bool interrupted();
bool interrupted_for_seconds();  // long enough to finish a frame of usual length

// Throws Error (Exit::interrupted) where one was caught: of work that leaves nothing to go on from.
void demand_no_interrupt();

}  // namespace drape
