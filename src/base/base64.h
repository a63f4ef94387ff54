// Bytes as text, for pictures inside a page.
#pragma once

#include <string>
#include <string_view>

namespace drape {

// RFC 4648's base 64, padded.
std::string base64(std::string_view bytes);

}  // namespace drape
