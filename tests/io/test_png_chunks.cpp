#include "io/png_chunks.h"

#include <libdeflate.h>

#include <catch2/catch.hpp>

#include "base/error.h"
#include "io/bytes.h"
#include "io/png.h"
#include "support/meshes.h"

using namespace drape;

namespace {

const std::string signature("\x89PNG\r\n\x1a\n", 8);
// two pixels of a palette: indices 0 and 1
const std::string header("\0\0\0\2\0\0\0\1\1\3\0\0\0", 13);
const std::string indices("\x78\x01\x01\x02\x00\xfd\xff\x00\x40\x00\x42\x00\x41", 13);

std::string big(std::uint32_t number) {
    std::vector<std::uint8_t> bytes;
    put<std::endian::big>(bytes, number);
    return {bytes.begin(), bytes.end()};
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string summed = type + data;
    return big(static_cast<std::uint32_t>(data.size())) + summed +
           big(libdeflate_crc32(0, summed.data(), summed.size()));
}

const std::string end = chunk("IEND", "");

std::string refusal(const std::string& chunks) {
    return error_of([&] { decode_png("a.png", signature + chunks); });
}

}  // namespace

TEST_CASE("a PNG is plain once what says nothing of its pixels is left out", "[io]") {
    const std::string png = signature + chunk("IHDR", header) + chunk("tEXt", "by nobody") +
                            chunk("PLTE", "abc") + chunk("IDAT", "") + chunk("IDAT", indices.substr(0, 5)) +
                            chunk("IDAT", indices.substr(5)) + end + "and more";
    const std::string plain = plain_png("a.png", png);
    CHECK(plain.find("tEXt") == std::string::npos);
    CHECK(plain.find(indices) != std::string::npos);
    // a colour beyond the palette is black
    CHECK(decode_png("a.png", png).rgb == std::vector<std::uint8_t>{'a', 'b', 'c', 0, 0, 0});
}

TEST_CASE("a damaged PNG is refused with the chunk that is", "[io]") {
    const std::string start = chunk("IHDR", header), palette = chunk("PLTE", "abc"),
                      data = chunk("IDAT", indices);
    CHECK(refusal(start + palette + data) == "a.png: the picture is cut off: no IEND chunk");
    CHECK(refusal(start + palette + data.substr(0, 20)) ==
          "a.png: the picture is cut off within its IDAT chunk");
    CHECK(refusal(start + palette + end) == "a.png: the picture has no data: no IDAT chunk");
    CHECK(refusal(start + chunk("PLTE", "abcd") + data + end).find("palette has 4 bytes") !=
          std::string::npos);
    CHECK(refusal(start + chunk("ZZZZ", "") + data + end).find("has a chunk ZZZZ") != std::string::npos);
    CHECK(refusal(start + chunk("a\nbc", "") + data + end).find("not four letters") != std::string::npos);
    std::string changed = start + palette + data + end;
    changed[start.size() + 9] ^= 1;
    CHECK(refusal(changed) == "a.png: is damaged: its PLTE chunk has another checksum");
}
