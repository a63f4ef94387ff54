#include "compare/tiles.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"

namespace drape {

std::vector<Tile> changed_tiles(const Image& picture, const Image& reference, int reach) {
    constexpr int side = 64;
    DRAPE_ASSERT(picture.width == reference.width && picture.height == reference.height);
    const auto differs = [&](const Tile& tile) {
        const int left = std::max(tile.left - reach, 0), right = std::min(tile.right + reach, picture.width);
        const int bottom = std::min(tile.bottom + reach, picture.height);
        for (int y = std::max(tile.top - reach, 0); y < bottom; ++y)
            if (std::memcmp(picture.pixel(left, y), reference.pixel(left, y),
                            3 * static_cast<size_t>(right - left)) != 0)
                return true;
        return false;
    };
    std::vector<Tile> tiles;
    for (int top = 0; top < picture.height; top += side) {
        for (int left = 0; left < picture.width; left += side) {
            const Tile tile{left, top, std::min(left + side, picture.width),
                            std::min(top + side, picture.height)};
            if (differs(tile)) tiles.push_back(tile);
        }
    }
    return tiles;
}

}  // namespace drape
