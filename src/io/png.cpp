#include "io/png.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <new>
#include <string_view>

#include "base/assert.h"
#include "base/error.h"
#include "io/png_chunks.h"
#include "io/read_file.h"

namespace {

// libdeflate in place of stb's own compressor: a quarter of the time for a 720p frame, and smaller files.
// stb frees the result with free().
unsigned char* compress_by_libdeflate(unsigned char* data, int size, int* compressed_size, int level) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    if (!compressor) return nullptr;
    const size_t bound = libdeflate_zlib_compress_bound(compressor.get(), static_cast<size_t>(size));
    auto* bytes = static_cast<unsigned char*>(std::malloc(bound));
    if (!bytes) return nullptr;
    *compressed_size = static_cast<int>(
        libdeflate_zlib_compress(compressor.get(), data, static_cast<size_t>(size), bytes, bound));
    return bytes;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_by_libdeflate
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>

namespace drape {

namespace {

constexpr std::uint64_t largest_picture = 1ULL << 30;  // [bytes]

// stb keeps these in globals: set before any thread can encode, read-only from then on
[[maybe_unused]] const bool stb_is_set = [] {
    constexpr int sub =
        1;  // difference to the pixel at the left: nearly as small as the best, no search for it
    stbi_write_force_png_filter = sub;
    stbi_write_png_compression_level = 1;
    return true;
}();

constexpr size_t header_bytes = 26;

struct PngHeader {
    int width = 0, height = 0;
    int bits = 0;  // of a pixel
};

PngHeader header_of(const std::string& path, std::string_view bytes) {
    constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8), first_chunk("IHDR");
    if (bytes.size() < header_bytes || !bytes.starts_with(signature) || bytes.substr(12, 4) != first_chunk)
        throw Error(cat(path, ": is not a PNG picture: no header of one"));
    const auto number = [&](size_t at) {
        unsigned value = 0;
        for (const char byte : bytes.substr(at, 4)) value = value << 8 | static_cast<unsigned char>(byte);
        return static_cast<int>(std::min(value, unsigned{std::numeric_limits<int>::max()}));
    };
    // by colour type: grey, none, RGB, palette, grey with alpha, none, RGB with alpha
    constexpr std::array channels{1, 0, 3, 1, 2, 0, 4};
    const auto depth = static_cast<unsigned char>(bytes[24]), type = static_cast<unsigned char>(bytes[25]);
    return {number(16), number(20), type < channels.size() ? channels[type] * depth : 0};
}

// Deflate makes at most 1032 bytes of one: a file that declares more pixels does not have them, and is told
// so before stb makes room for them.
void demand_room(const std::string& path, std::string_view bytes) {
    constexpr double most_of_a_byte = 1032;
    const PngHeader header = header_of(path, bytes);
    if (double(header.width) * header.height * header.bits / 8 > most_of_a_byte * double(bytes.size()))
        throw Error(cat(path, ": declares ", header.width, "x", header.height, " pixels, more than its ",
                        bytes.size(), " bytes can hold"));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
    DRAPE_ASSERT(image.width > 0 && image.height > 0);
    // stb counts bytes in int
    const long long bytes = (3LL * image.width + 1) * image.height;
    if (bytes > std::numeric_limits<int>::max())
        throw Error(
            cat("a picture of ", image.width, " x ", image.height, " is too large for a PNG (at most 2 GB)"));
    int size = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> png(
        stbi_write_png_to_mem(image.rgb.data(), 3 * image.width, image.width, image.height, 3, &size),
        std::free);
    if (!png) throw std::bad_alloc();
    return std::vector<std::uint8_t>(png.get(), png.get() + size);
}

Image read_png(const std::string& path) {
    return decode_png(path, read_file(path, largest_picture));
}

Image decode_png(const std::string& path, std::string_view bytes) {
    demand_room(path, bytes);
    const std::string plain = plain_png(path, bytes);
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const unsigned char*>(plain.data()),
                              static_cast<int>(plain.size()), &width, &height, &channels, 3),
        std::free);
    if (!pixels) throw Error(cat(path, ": is not a PNG picture: ", stbi_failure_reason()));
    Image image(width, height);
    std::copy_n(pixels.get(), image.rgb.size(), image.rgb.begin());
    return image;
}

std::array<int, 2> read_png_size(const std::string& path) {
    check_readable(path, largest_picture);
    std::ifstream file(path, std::ios::binary);
    std::array<char, header_bytes> bytes{};
    file.read(bytes.data(), bytes.size());
    const PngHeader header = header_of(path, {bytes.data(), static_cast<size_t>(file.gcount())});
    return {header.width, header.height};
}

}  // namespace drape
