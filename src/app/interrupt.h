// Ctrl-C and SIGTERM ask a run to stop after the frame in hand; a second one stops at once.
#pragma once

namespace drape {

void catch_interrupts();
bool interrupted();

}  // namespace drape
