// A folder of numbered pictures.
#pragma once

#include <string>
#include <vector>

namespace drape {

struct Sequence {
    std::string folder;
    std::vector<std::string> files;  // paths, in the order of their numbers
    int first = 1;                   // number of the first; the others follow without a gap
    int width = 0, height = 0;       // of every picture [pixels]

    int frames() const { return static_cast<int>(files.size()); }
};

// frame_0001.png and so on; or, where there are none, all that differ in their number alone. Throws Error
// naming the folder or file: nothing numbered, a number missing or there twice, pictures of several sizes.
Sequence find_sequence(const std::string& folder);

}  // namespace drape
