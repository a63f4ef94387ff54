// Whether a page is well formed.
#pragma once

#include <string>

namespace drape::test {

// The first tag that is opened and not closed in turn; "" if all are.
std::string unbalanced(const std::string& page);

}  // namespace drape::test
