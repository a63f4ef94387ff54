// Words about a picture, drawn into it on a dark band.
#pragma once

#include <string>
#include <vector>

#include "base/image.h"

namespace drape {

struct Caption {
    std::string title;
    std::vector<std::string> facts;  // follow the title, set apart by dots

    bool empty() const { return title.empty() && facts.empty(); }
};

enum class Corner { top_left, bottom_left };

// Lines are broken where they are wider than the picture, between facts or words. Pictures too small to hold
// legible letters (under 120 x 90) get none.
void draw_caption(Image& image, const Caption& caption, Corner corner = Corner::bottom_left);

}  // namespace drape
