// A file's ending names its format.
#pragma once

#include <filesystem>
#include <string>

namespace drape {

// ".obj" for "cloth/Cape.OBJ"; "" if there is none.
inline std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return ending;
}

}  // namespace drape
