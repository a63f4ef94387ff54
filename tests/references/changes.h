// Small changes that a picture's reference must be told apart from.
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

}  // namespace drape::test
