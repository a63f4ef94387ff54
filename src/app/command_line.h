// The command line: verbs, flags, exit codes (the README's command contract).
#pragma once

namespace drape {

// Runs the verb that argv names; errors become one line on stderr. Returns the process's exit code.
int run_command_line(int argc, char** argv);

}  // namespace drape
