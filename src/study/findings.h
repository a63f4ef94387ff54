// What a study says: the cheapest way to an error, and the order each method shows.
#pragma once

#include <optional>

#include "study/study.h"

namespace drape {

// The cheapest rung whose error is at most that [m]; null if there is none.
const Rung* cheapest_under(const Study& study, double metres);

// Of one method: the cheapest rung under that error, or else the most accurate one.
const Rung* representative(const Study& study, const Method& method, double metres);

// The slope of error over step, both logarithms, over the shortest steps whose error stands clear of the
// reference's bar.
struct SeenOrder {
    std::optional<double> seen;  // none: fewer than two such rungs
    int expected = 0;
    int rungs = 0;
};
SeenOrder seen_order(const Study& study, const Method& method);

}  // namespace drape
