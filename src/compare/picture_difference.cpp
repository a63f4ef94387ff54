#include "compare/picture_difference.h"

#include <algorithm>
#include <cstdlib>

#include "base/assert.h"

namespace drape {

PictureDifference picture_difference(const Image& picture, const Image& reference) {
    constexpr int visible = 8;  // levels
    DRAPE_ASSERT(picture.rgb.size() == reference.rgb.size());
    double sum = 0, over = 0;
    for (size_t i = 0; i < picture.rgb.size(); i += 3) {
        int most = 0;
        for (size_t c = i; c < i + 3; ++c) {
            const int apart = std::abs(int{picture.rgb[c]} - int{reference.rgb[c]});
            sum += apart;
            most = std::max(most, apart);
        }
        over += most > visible ? 1 : 0;
    }
    const auto values = static_cast<double>(picture.rgb.size());
    return {sum / values, 3 * over / values};
}

}  // namespace drape
