#include "study/plot_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape {

bool LabelBox::meets(const LabelBox& other) const {
    const Pixel apart = (centre - other.centre).cwiseAbs(), reach = half + other.half;
    return apart.x() < reach.x() && apart.y() < reach.y();
}

// Liang and Barsky: what is left of the segment between the box's four sides
bool LabelBox::meets(const Pixel& a, const Pixel& b) const {
    double from = 0, to = 1;
    for (int c = 0; c < 2; ++c) {
        const double way = b[c] - a[c], low = centre[c] - half[c] - a[c], high = centre[c] + half[c] - a[c];
        if (way == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        from = std::max(from, std::min(low / way, high / way));
        to = std::min(to, std::max(low / way, high / way));
    }
    return from < to;
}

bool PlotLabels::is_free(const LabelBox& box) const {
    if (((box.centre - box.half).array() < low_.array()).any()) return false;
    if (((box.centre + box.half).array() > high_.array()).any()) return false;
    if (std::any_of(boxes_.begin(), boxes_.end(), [&](const LabelBox& b) { return box.meets(b); }))
        return false;
    return std::none_of(segments_.begin(), segments_.end(),
                        [&](const Segment& s) { return box.meets(s.a, s.b); });
}

std::optional<Pixel> PlotLabels::place(const Pixel& dot, const Pixel& half) {
    constexpr double gap = 5;
    // right first, then round the dot
    constexpr std::array<std::array<double, 2>, 8> ways{
        {{1, 0.6}, {1, -0.6}, {-1, -0.6}, {-1, 0.6}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}}};
    for (const double farther : {1.0, 2.2, 3.4}) {
        for (const auto& way : ways) {
            const Pixel side(way[0], way[1]);
            const LabelBox box{dot + side.cwiseProduct(half + Pixel::Constant(gap * farther)), half};
            if (!is_free(box)) continue;
            boxes_.push_back(box);
            return box.centre;
        }
    }
    return std::nullopt;
}

}  // namespace drape
