// Which folder may include which: the order the data flows, as a table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::test {

struct Layer {
    std::string_view folder;
    std::string_view may_include;  // besides itself: folders, a space between; "*": every folder
};

std::span<const Layer> layers();

// "FILE:LINE: render may not include scene/reader.h" for each `#include "` of the text that points up, to no
// known folder, or out of a folder that has no row in the table. `file` is a path under src.
std::vector<std::string> upward_includes(std::string_view file, std::string_view text);

}  // namespace drape::test
