// Videos as ffmpeg makes them, looked at with ffprobe. Skipped, with a warning, where the two are not
// installed.
#include "video/encoder.h"

#include <array>

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/ffmpeg.h"
#include "support/frames.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Matchers::Contains;

namespace {

void encode(const std::string& path, int frames, int width, int height, double rate) {
    Encoder encoder(path, {width, height, rate});
    do
        for (int k = 0; k < frames; ++k) encoder.add(moving_disc(k, width, height));
    while (encoder.another_pass());
    encoder.finish();
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int(a.rgb[i]) - int(b.rgb[i]));
    return sum / static_cast<double>(a.rgb.size());
}

std::uint32_t little_endian(const std::string& bytes, size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= std::uint32_t{static_cast<std::uint8_t>(bytes.at(at + static_cast<size_t>(i)))} << (8 * i);
    return value;
}

}  // namespace

TEST_CASE("mp4, webm and gif have the codec, size, frames and duration asked for", "[video]") {
    if (skipped_without_ffmpeg()) return;
    const struct {
        std::string file, codec, pixels;
        double late;  // how much longer the last frame may be shown [s]
    } cases[] = {
        {"a.mp4", "h264", "yuv420p", 0}, {"a.webm", "vp9", "yuv420p", 0}, {"a.gif", "gif", "bgra", 0.02}};
    const TemporaryFolder folder;
    for (const auto& c : cases) {
        const std::string path = folder.file(c.file);
        encode(path, 12, 64, 36, 24);
        const std::string says = probed(path);
        CAPTURE(c.file, says);
        CHECK(value_of(says, "codec_name") == c.codec);
        CHECK(value_of(says, "width") == "64");
        CHECK(value_of(says, "height") == "36");
        CHECK(value_of(says, "pix_fmt") == c.pixels);
        CHECK(value_of(says, "nb_read_frames") == "12");
        const size_t format = says.find("[FORMAT]");
        CHECK(std::stod(value_of(says.substr(format), "duration")) == Approx(0.5).margin(0.001 + c.late));
        if (c.pixels != "yuv420p") continue;
        for (const char* key : {"color_space", "color_transfer", "color_primaries"})
            CHECK(value_of(says, key) == "bt709");
        CHECK(value_of(says, "color_range") == "tv");
    }
    CHECK(folder.files() == 3);  // no palette, nothing temporary
}

// ffprobe 5.1 does not read animated WebP: its chunks are counted here, as the WebP container specification
// has them.
TEST_CASE("a webp has its size, every frame and its duration, and loops for ever", "[video]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    encode(folder.file("a.webp"), 12, 65, 37, 20);
    const std::string bytes = bytes_of(folder.file("a.webp"));
    REQUIRE(bytes.substr(0, 4) == "RIFF");
    REQUIRE(bytes.substr(8, 8) == "WEBPVP8X");
    CHECK(little_endian(bytes, 24, 3) + 1 == 65);
    CHECK(little_endian(bytes, 27, 3) + 1 == 37);
    int frames = 0, milliseconds = 0, loops = -1;
    for (size_t at = 12; at + 8 <= bytes.size(); at += 8 + (little_endian(bytes, at + 4, 4) + 1) / 2 * 2) {
        const std::string chunk = bytes.substr(at, 4);
        if (chunk == "ANIM") loops = static_cast<int>(little_endian(bytes, at + 12, 2));
        if (chunk != "ANMF") continue;
        ++frames;
        milliseconds += static_cast<int>(little_endian(bytes, at + 8 + 12, 3));
    }
    CHECK(frames == 12);
    CHECK(milliseconds == 600);
    CHECK(loops == 0);
}

TEST_CASE("a frame of a video shows the colours of its picture", "[video]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    const struct {
        std::string file;
        double levels;  // mean difference; measured: 0.9, 0.7, 1.8, and 11 from another frame
    } cases[] = {{"a.mp4", 1.2}, {"a.webm", 1.2}, {"a.gif", 2.5}};
    for (const auto& c : cases) {
        encode(folder.file(c.file), 6, 128, 72, 30);
        const Image frame = decoded_frame(folder.file(c.file), 4, 128, 72);
        CAPTURE(c.file);
        CHECK(mean_difference(frame, moving_disc(4, 128, 72)) < c.levels);
        CHECK(mean_difference(frame, moving_disc(1, 128, 72)) > 2 * c.levels);
        // the red of the disc, which the matrix of BT.601 would shift by 12 levels
        const Image picture = moving_disc(4, 128, 72);
        for (int channel = 0; channel < 3; ++channel)
            CHECK(std::abs(frame.pixel(51, 36)[channel] - picture.pixel(51, 36)[channel]) <= 6);
    }
}

TEST_CASE("odd sizes gain a pixel where colour is stored at half the resolution, and show nothing new",
          "[video]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    encode(folder.file("a.mp4"), 2, 65, 37, 30);
    const std::string says = probed(folder.file("a.mp4"));
    CHECK(value_of(says, "width") == "66");
    CHECK(value_of(says, "height") == "38");
    const Image frame = decoded_frame(folder.file("a.mp4"), 0, 66, 38);
    for (int y = 0; y < 38; ++y) CHECK(std::abs(frame.pixel(65, y)[1] - frame.pixel(64, y)[1]) < 12);
    encode(folder.file("a.gif"), 2, 65, 37, 30);
    CHECK(value_of(probed(folder.file("a.gif")), "width") == "65");
    encode(folder.file("one.mp4"), 1, 1, 1, 30);
    CHECK(value_of(probed(folder.file("one.mp4")), "nb_read_frames") == "1");
}

TEST_CASE("the same frames give the same bytes", "[video]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    for (const std::string name : {"a.mp4", "a.webm", "a.webp", "a.gif"}) {
        encode(folder.file(name), 4, 64, 36, 30);
        const std::string once = bytes_of(folder.file(name));
        encode(folder.file(name), 4, 64, 36, 30);
        CAPTURE(name);
        CHECK(once == bytes_of(folder.file(name)));
    }
}

TEST_CASE("a mp4 begins with its index, so that it plays while it loads", "[video]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    encode(folder.file("a.mp4"), 4, 64, 36, 30);
    const std::string bytes = bytes_of(folder.file("a.mp4"));
    CHECK(bytes.find("moov") < bytes.find("mdat"));
}

TEST_CASE("a video that cannot be made leaves one line and no file", "[video]") {
    const TemporaryFolder folder;
    const std::string programs = folder.file("programs");
    std::filesystem::create_directory(programs);
    const Environment path("PATH", programs);
    const auto complaint = [&](const std::string& name) -> std::string {
        try {
            encode(folder.file(name), 12, 640, 360, 30);
        } catch (const Error& error) {
            CHECK(error.code() == Exit::cannot_write);
            return error.what();
        }
        return "";
    };
    const auto ffmpeg = [&](const std::string& script) {
        folder.file("programs/ffmpeg", "#!/bin/sh\n" + script);
        std::filesystem::permissions(programs + "/ffmpeg", std::filesystem::perms::owner_all);
    };
    for (const std::string name : {"a.mp4", "a.gif"}) {
        std::filesystem::remove(programs + "/ffmpeg");
        CHECK(complaint(name) == folder.file(name) + ": cannot write: ffmpeg is not installed");
        ffmpeg("echo one >&2\necho 'Unknown encoder' >&2\nexit 1\n");
        CHECK(complaint(name) == folder.file(name) + ": cannot write: ffmpeg: Unknown encoder");
        ffmpeg("/bin/dd bs=65536 count=1 of=/dev/null 2>/dev/null\nkill -9 $$\n");
        CHECK(complaint(name) == folder.file(name) + ": cannot write: ffmpeg was ended by a signal: Killed");
        ffmpeg("exit 0\n");
        CHECK(complaint(name) == folder.file(name) + ": cannot write: ffmpeg ended before the last frame");
        CHECK(folder.files() == 1);
    }
    folder.file("b.mp4", "what was there before");
    complaint("b.mp4");
    CHECK(bytes_of(folder.file("b.mp4")) == "what was there before");
    CHECK_THAT(complaint("none/a.mp4"), Contains("none/a.mp4: cannot write: No such file or directory"));
}
