// How far points moved apart at most since a moment: bounds how much any distance between two of them
// changed. What they moved together, or turned as one body, does not count.
//
// With any turn R the distance of two points that went from a, b to x, y changed by no more than
// |(x - R a) - (y - R b)|: the diagonal of the box around what is left of all moves bounds that. R is that
// which fits best (Kabsch), on some of the points.
#pragma once

#include <utility>
#include <vector>

#include "base/points.h"

namespace drape {

class Drift {
public:
    // Of columns first .. first + count - 1 of each range.
    explicit Drift(std::vector<std::pair<int, int>> ranges);

    void begin(In x) { from_ = x; }
    bool is_within(In x, double limit) const;  // whether no distance changed by more [m]

    // How much straight moves change any distance, whatever part of them is gone [m].
    double of(In move) const;
    // How fast any distance shrinks at most [m/s].
    double rate(In x, In v) const;

private:
    Vec3 middle_of(In x) const;  // of some columns [m]
    Mat3 turn_to(In x) const;
    Vec3 spin(In x, In v) const;  // [rad/s]
    template <class Way>
    double spread(Way way) const;  // of what `way` gives for a column

    std::vector<std::pair<int, int>> ranges_;
    std::vector<int> some_;  // columns that turns are fitted to
    Points from_;
};

}  // namespace drape
