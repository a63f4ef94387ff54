#include "picture/caption.h"

#include <catch2/catch.hpp>

using namespace drape;

namespace {

constexpr std::uint8_t paper = 200;

Image grey(int width, int height) {
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), paper);
    return image;
}

struct Box {
    int left = 10000, top = 10000, right = -1, bottom = -1, bright = 0;
};

// Where the picture was changed, and how many of its pixels are letters.
Box drawn(int width, int height, const Caption& caption, Corner corner = Corner::bottom_left) {
    Image image = grey(width, height);
    draw_caption(image, caption, corner);
    Box box;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int level = image.pixel(x, y)[0];
            if (level == paper) continue;
            box.left = std::min(box.left, x);
            box.right = std::max(box.right, x);
            box.top = std::min(box.top, y);
            box.bottom = std::max(box.bottom, y);
            box.bright += level > 230;
        }
    return box;
}

}  // namespace

TEST_CASE("a caption stands on a dark band in its corner, clear of the borders", "[picture]") {
    const Caption caption{"cotton on a ball", {"verlet", "step 65 µs"}};
    const Box low = drawn(640, 360, caption), high = drawn(640, 360, caption, Corner::top_left);
    CHECK(low.bright > 50);
    CHECK(high.bright == low.bright);
    CHECK(low.left > 3);
    CHECK(low.left < 15);
    CHECK(low.right < 320);
    CHECK(low.bottom < 357);
    CHECK(low.top > 320);
    CHECK(high.bottom < 40);
    CHECK(low.bottom - low.top == high.bottom - high.top);
}

TEST_CASE("a caption wider than the picture is broken into lines", "[picture]") {
    const Caption facts{"cotton on a ball",
                        {"takahashi_imada", "step 65 µs", "870 ms a frame", "error 3 mm"}};
    const Box wide = drawn(1280, 360, facts), narrow = drawn(160, 360, facts);
    CHECK(narrow.bottom - narrow.top > 2 * (wide.bottom - wide.top));
    CHECK(narrow.right < 160 - 3);
    const Box words = drawn(160, 360, {"one two three four five six seven eight nine ten eleven twelve", {}});
    CHECK(words.right < 160 - 3);
    CHECK(words.bright > 100);
}

TEST_CASE("facts change where they stand by nothing but their own width", "[picture]") {
    const Caption caption{"a", {"b"}};
    CHECK(drawn(640, 360, {"a", {"b", "c"}}).right > drawn(640, 360, caption).right);
    CHECK(drawn(640, 360, {"a", {"c"}}).left == drawn(640, 360, caption).left);
}

TEST_CASE("an empty caption and a picture too small for letters leave the picture as it is", "[picture]") {
    CHECK(drawn(640, 360, {}).right == -1);
    CHECK(drawn(640, 360, {"  ", {}}).right == -1);
    CHECK(drawn(119, 360, {"text", {}}).right == -1);
    CHECK(drawn(640, 89, {"text", {}}).right == -1);
}
