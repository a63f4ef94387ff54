#include "compare/picture_difference.h"

#include <algorithm>
#include <cstdlib>

#include "base/assert.h"
#include "compare/density.h"
#include "compare/edge_shift.h"

namespace drape {

PictureDifference picture_difference(const Image& picture, const Image& reference) {
    constexpr int visible = 8;  // levels
    DRAPE_ASSERT(picture.width == reference.width && picture.height == reference.height);
    PictureDifference apart;
    const size_t pixels = picture.rgb.size() / 3;
    if (pixels == 0) return apart;
    std::vector<std::uint8_t> over(pixels);
    std::int64_t sum = 0, count = 0, off_edges = 0;
    for (size_t i = 0; i < pixels; ++i) {
        int most = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; ++c) {
            const int levels = std::abs(int{picture.rgb[c]} - int{reference.rgb[c]});
            sum += levels;
            most = std::max(most, levels);
        }
        ++apart.histogram[static_cast<size_t>(most)];
        if (most <= visible) continue;
        over[i] = 1;
        ++count;
        const int x = static_cast<int>(i) % picture.width, y = static_cast<int>(i) / picture.width;
        if (!explained_by_shift(picture, reference, x, y, visible)) ++off_edges;
    }
    const auto all = static_cast<double>(pixels);
    apart.mean_levels = static_cast<double>(sum) / (3 * all);
    apart.share_over = static_cast<double>(count) / all;
    apart.share_off_edges = static_cast<double>(off_edges) / all;
    if (count > 0) {
        const DensestWindow window = densest_window(over, picture.width, picture.height, 32);
        apart.density = window.share;
        apart.densest = {window.x, window.y};
    }
    return apart;
}

}  // namespace drape
