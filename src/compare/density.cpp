#include "compare/density.h"

#include <algorithm>
#include <vector>

#include "base/assert.h"

namespace drape {

DensestWindow densest_window(std::span<const std::uint8_t> marked, int width, int height, int side) {
    DRAPE_ASSERT(marked.size() == static_cast<size_t>(width) * static_cast<size_t>(height));
    const int across = std::min(side, width), down = std::min(side, height);
    const auto row = [&](int y) {
        return marked.data() + static_cast<size_t>(y) * static_cast<size_t>(width);
    };
    // marked pixels of each column within the window's rows, moved down a row at a time
    std::vector<int> column(static_cast<size_t>(width));
    int most = 0;
    DensestWindow densest;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) column[static_cast<size_t>(x)] += row(y)[x];
        if (y >= down)
            for (int x = 0; x < width; ++x) column[static_cast<size_t>(x)] -= row(y - down)[x];
        if (y < down - 1) continue;
        int inside = 0;
        for (int x = 0; x < width; ++x) {
            inside += column[static_cast<size_t>(x)];
            if (x >= across) inside -= column[static_cast<size_t>(x - across)];
            if (x < across - 1 || inside <= most) continue;
            most = inside;
            densest = {static_cast<double>(inside) / (across * down), x - across + 1, y - down + 1};
        }
    }
    return densest;
}

}  // namespace drape
