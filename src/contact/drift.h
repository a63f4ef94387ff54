// How far points moved apart at most since a moment: bounds how much any distance between two of them
// changed. What they moved together does not count.
#pragma once

#include <utility>
#include <vector>

#include "base/points.h"

namespace drape {

class Drift {
public:
    // Of columns first .. first + count - 1 of each range.
    explicit Drift(std::vector<std::pair<int, int>> ranges) : ranges_(std::move(ranges)) {}

    void begin(In x) { from_ = x; }
    double at(In x) const;     // [m]
    double of(In move) const;  // that a move makes

private:
    std::vector<std::pair<int, int>> ranges_;
    Points from_;
};

}  // namespace drape
