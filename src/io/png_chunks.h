// What a PNG's chunks say of the picture, checked before a decoder sees it.
#pragma once

#include <string>
#include <string_view>

namespace drape {

// The same picture in the plainest PNG: header, palette, transparency and one run of data, its checksums left
// out. Throws Error where a chunk does not end within the file, has another checksum than it declares or must
// be understood and is not; or where there is no data. (stb looks at no checksum, makes room for what a chunk
// declares, quotes what a chunk is called, and takes colours beyond the palette from memory that nobody has
// set: here they are black.)
std::string plain_png(const std::string& path, std::string_view bytes);

}  // namespace drape
