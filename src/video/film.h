// Sequences put together, one after the other or side by side. A frame is read and composed when it is asked
// for: none is kept.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/image.h"
#include "video/captions.h"
#include "video/sequence.h"

namespace drape {

struct Take {
    Sequence sequence;
    Captions captions;
    std::string label;  // of its pane, in the corner; "" = none
    int width = 0;      // its pictures are resized to [pixels]; 0 = as they are

    int height() const;  // in proportion
};

class Film {
public:
    virtual ~Film() = default;
    virtual int frames() const = 0;
    virtual Image frame(int k) const = 0;  // 0 <= k < frames(), each of one size
};

// `takes` follow each other. Throws Error where their pictures are not of one size.
std::unique_ptr<Film> one_after_the_other(std::vector<Take> takes);

struct PaneLayout {
    int columns = 0;          // 0 = all in one row
    bool difference = false;  // of two takes, 16 times as strong, in a pane of its own
};

// `takes` run together in panes. Throws Error where they differ in size or number of frames.
std::unique_ptr<Film> side_by_side(std::vector<Take> takes, const PaneLayout& layout);

}  // namespace drape
