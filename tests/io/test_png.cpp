#include "io/png.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "io/write_file.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

Image noisy(int width, int height) {
    Image image(width, height);
    unsigned random = 7;
    for (auto& byte : image.rgb)
        byte = static_cast<std::uint8_t>((random = random * 1664525 + 1013904223) >> 24);
    return image;
}

}  // namespace

TEST_CASE("a picture comes back from its PNG bit by bit, whatever its size", "[io]") {
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {640, 5}, {3, 400}}) {
        CAPTURE(width, height);
        const Image image = noisy(width, height);
        write_file(folder.file("picture.png"), encode_png(image));
        const Image back = read_png(folder.file("picture.png"));
        CHECK(back.width == width);
        CHECK(back.height == height);
        CHECK(back.rgb == image.rgb);
        CHECK(read_png_size(folder.file("picture.png")) == std::array{width, height});
    }
}

TEST_CASE("the same picture gives the same PNG bytes", "[io]") {
    CHECK(encode_png(noisy(60, 40)) == encode_png(noisy(60, 40)));
}

TEST_CASE("a smooth picture is much smaller as a PNG: it is compressed, and filtered before", "[io]") {
    Image image(256, 256);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = static_cast<std::uint8_t>(x + c * y);
    CHECK(encode_png(image).size() < image.rgb.size() / 20);
}

TEST_CASE("what is not a PNG is refused by name", "[io]") {
    const TemporaryFolder folder;
    const std::string text = folder.file("text.png", "not a picture at all");
    CHECK(error_of([&] { read_png(text); }).starts_with(text + ": is not a PNG picture"));
    CHECK(error_of([&] { read_png(folder.file("none.png")); }).find("no such file") != std::string::npos);
    CHECK(error_of([&] { read_png_size(text); }).starts_with(text + ": is not a PNG picture"));
    const std::string signature = folder.file("signature.png", "\x89PNG\r\n\x1a\n");
    CHECK(error_of([&] { read_png_size(signature); }).starts_with(signature + ": is not a PNG picture"));
    const auto png = encode_png(noisy(50, 50));
    const std::string cut = folder.file("cut.png", std::string(png.begin(), png.begin() + 3000));
    CHECK(error_of([&] { read_png(cut); }).starts_with(cut));
}
