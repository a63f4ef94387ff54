// What passes for the same: a limit for each metric, and parts of pictures that are not looked at.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/image.h"
#include "toml/place.h"

namespace drape {

// By a metric's key (metrics.h). A metric without one is told, not judged.
using Limits = std::map<std::string, double, std::less<>>;

// "KEY=VALUE", as --limit takes it, into `limits`. Throws Error that says what is allowed.
void add_limit(Limits& limits, const std::string& text);

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;  // pixels, from the upper left
};

// "X,Y,W,H". Throws Error that says what is allowed.
Rectangle rectangle_of(const std::string& text);

// Gives `picture` the reference's pixels there, so that nothing differs. Throws Error for a rectangle that
// lies wholly outside; what sticks out is cut off.
void ignore(Image& picture, const Image& reference, const std::vector<Rectangle>& rectangles);

// compare.toml, beside the references.
struct LimitFile {
    Limits limits;
    std::vector<Rectangle> ignore;
    struct Special {
        std::string file;  // the name of the only file that it is for
        Place place;
        Limits limits;
    };
    std::vector<Special> special;
};

// What the file says; nothing where there is none. Throws Error "FILE:LINE:COL: what is wrong (what is
// allowed)".
LimitFile read_limits(const std::string& path);

}  // namespace drape
