#include "video/format.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace drape;

namespace {

using Words = std::vector<std::string>;

// Whether `some` stand in `words` in this order, one right after the other.
bool has(const Words& words, const Words& some) {
    return std::search(words.begin(), words.end(), some.begin(), some.end()) != words.end();
}

}  // namespace

TEST_CASE("the ending of the file says which video it is", "[video]") {
    for (const std::string name : {".mp4", ".webm", ".webp", ".gif"})
        CHECK(format_of("some/film" + name).name == name);
    CHECK(format_of("FILM.MP4").name == ".mp4");
    CHECK_THROWS_WITH(format_of("film.mp5"), Catch::Contains("film.mp5: unknown ending of a video") &&
                                                 Catch::Contains("did you mean \".mp4\"?"));
    CHECK_THROWS_WITH(format_of("film"), Catch::Contains(".mp4, .webm, .webp, .gif"));
}

TEST_CASE("ffmpeg is told of raw frames, their size and rate, and of a file that is no flag", "[video]") {
    for (const std::string name : {"-a.mp4", "-a.webm", "-a.webp", "-a.gif"}) {
        const Words words = encode_words(format_of(name), {641, 360, 29.97}, 50, name, "p.png");
        CHECK(words.front() == "ffmpeg");
        CHECK(words.back() == "file:" + name);
        CHECK(has(words, {"-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", "641x360", "-framerate",
                          "29.97", "-i", "pipe:0"}));
        CHECK(has(words, {"-nostdin"}));
        CHECK(has(words, {"-xerror"}));  // or a full disk would go unnoticed
        CHECK(std::find(words.begin(), words.end(), "") == words.end());
    }
}

TEST_CASE("each format is encoded as its players expect", "[video]") {
    const auto words = [](const char* name) {
        return encode_words(format_of(name), {64, 36, 30}, 50, name, "p.png");
    };
    for (const char* name : {"a.mp4", "a.webm"}) {
        CHECK(has(words(name), {"-color_primaries", "bt709", "-color_trc", "bt709", "-colorspace", "bt709"}));
        CHECK(has(
            words(name),
            {"-vf",
             "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p"}));
    }
    CHECK(has(words("a.mp4"), {"-c:v", "libx264"}));
    CHECK(has(words("a.mp4"), {"-movflags", "+faststart"}));
    CHECK(has(words("a.webm"), {"-c:v", "libvpx-vp9"}));
    CHECK(has(words("a.webp"), {"-loop", "0"}));
    CHECK(has(words("a.webp"), {"-quality", "50"}));
    CHECK_FALSE(has(words("a.mp4"), {"-quality"}));
    CHECK(has(words("a.gif"), {"-i", "pipe:0", "-i", "file:p.png"}));
    CHECK(has(words("a.gif"), {"-loop", "0"}));
    CHECK(has(palette_words({64, 36, 30}, "p.png"), {"-vf", "palettegen"}));
    CHECK(palette_words({64, 36, 30}, "p.png").back() == "file:p.png");
}
