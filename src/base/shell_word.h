// Words of a command that is shown to be run.
#pragma once

#include <string>

namespace drape {

// A word of a command, quoted where a shell would make more or less of it.
std::string shell_word(const std::string& word);

}  // namespace drape
