// PNG in and out: stb_image and stb_image_write, with libdeflate as compressor.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"

namespace drape {

// The bytes of a PNG file; the same image gives the same bytes.
std::vector<std::uint8_t> encode_png(const Image& image);

// Throws Error naming the file if it is missing or not a picture.
Image read_png(const std::string& path);

// The same of a file's bytes that are at hand; `path` is for messages.
Image decode_png(const std::string& path, std::string_view bytes);

// Width and height, from the file's header alone; throws as read_png does.
std::array<int, 2> read_png_size(const std::string& path);

}  // namespace drape
