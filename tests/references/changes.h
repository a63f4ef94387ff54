// Small changes that references must be told apart from.
#pragma once

#include <span>
#include <string_view>

#include "references/references.h"

namespace drape::test {

struct Change {
    std::string_view name;
    Image (*of)(const Moment&);  // the picture with the change
};

std::span<const Change> changes();

// A cloth whose middle vertex is 1 mm higher, and those within 10 cm of it by as much less as they are away.
Points bumped(const Points& cloth);

}  // namespace drape::test
