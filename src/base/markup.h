// Text inside HTML and XML.
#pragma once

#include <string>

namespace drape {

// Safe as text and as an attribute's value; what XML allows nowhere, control characters and bytes that are
// not UTF-8, becomes a question mark.
std::string escaped(const std::string& text);

}  // namespace drape
