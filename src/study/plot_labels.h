// Finds room for small labels beside dots, so that none covers a dot, a line or another label. All in
// pixels, y up.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace drape {

using Pixel = Eigen::Vector2d;

struct LabelBox {
    Pixel centre, half;  // half width and height
    bool meets(const LabelBox& other) const;
    bool meets(const Pixel& a, const Pixel& b) const;  // the segment from a to b
};

class PlotLabels {
public:
    PlotLabels(const Pixel& low, const Pixel& high) : low_(low), high_(high) {}

    void keep_free(const LabelBox& box) { boxes_.push_back(box); }
    void keep_free(const Pixel& a, const Pixel& b) { segments_.push_back({a, b}); }

    // Where the label's centre goes, near `dot`; none: there is no room.
    std::optional<Pixel> place(const Pixel& dot, const Pixel& half);

private:
    struct Segment {
        Pixel a, b;
    };
    bool is_free(const LabelBox& box) const;

    Pixel low_, high_;
    std::vector<LabelBox> boxes_;
    std::vector<Segment> segments_;
};

}  // namespace drape
