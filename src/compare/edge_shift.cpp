#include "compare/edge_shift.h"

#include <algorithm>
#include <array>

namespace drape {

namespace {

// the colour of `one` at a pixel lies within the range of `other` around it
bool within_surroundings(const Image& one, const Image& other, int x, int y, int slack) {
    std::array<int, 3> least{255, 255, 255}, most{0, 0, 0};
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, other.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, other.width - 1); ++u) {
            const std::uint8_t* pixel = other.pixel(u, v);
            for (size_t c = 0; c < 3; ++c) {
                least[c] = std::min<int>(least[c], pixel[c]);
                most[c] = std::max<int>(most[c], pixel[c]);
            }
        }
    }
    const std::uint8_t* pixel = one.pixel(x, y);
    for (size_t c = 0; c < 3; ++c)
        if (pixel[c] < least[c] - slack || pixel[c] > most[c] + slack) return false;
    return true;
}

}  // namespace

bool explained_by_shift(const Image& picture, const Image& reference, int x, int y, int slack) {
    return within_surroundings(picture, reference, x, y, slack) &&
           within_surroundings(reference, picture, x, y, slack);
}

}  // namespace drape
