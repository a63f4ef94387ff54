#include "video/format.h"

#include <array>
#include <cstdio>
#include <sstream>

#include "base/names.h"
#include "io/endings.h"

namespace drape {

namespace {

// Pictures are sRGB, whose primaries are BT.709's: its matrix and tags make players show the same colours.
constexpr std::string_view halved_colour =
    "-vf scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p "
    "-color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv";

constexpr std::array formats{
    VideoFormat{".mp4", "mp4", "-c:v libx264 -preset medium -crf 18 -threads 4 -movflags +faststart", 0, 60,
                true, false},
    VideoFormat{".webm", "webm",
                "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 4 -row-mt 1 -threads 4", 0, 60, true,
                false},
    VideoFormat{".webp", "webp", "-c:v libwebp_anim -compression_level 4 -loop 0", 80, 50, false, false},
    // an ordered dither stands still where the picture does, which keeps the file small
    VideoFormat{".gif", "gif", "-lavfi paletteuse=dither=bayer:bayer_scale=3:diff_mode=rectangle -loop 0", 0,
                50, false, true},
};

void add_words(std::vector<std::string>& words, std::string_view text) {
    std::istringstream stream{std::string(text)};
    for (std::string word; stream >> word;) words.push_back(word);
}

// Without -xerror a full disk leaves a cut video and exit code 0.
std::vector<std::string> input_words(const Canvas& canvas) {
    char rate[32];
    std::snprintf(rate, sizeof rate, "%.9g", canvas.rate);
    std::vector<std::string> words{"ffmpeg"};
    add_words(
        words,
        cat("-nostdin -hide_banner -loglevel error -xerror -y -f rawvideo -pixel_format rgb24 -video_size ",
            canvas.width, "x", canvas.height, " -framerate ", rate, " -i pipe:0"));
    return words;
}

// The name of a file is never taken for a protocol or a flag.
std::string file_word(const std::string& path) {
    return "file:" + path;
}

}  // namespace

const VideoFormat& format_of(const std::string& path) {
    return in_context(path, [&]() -> const VideoFormat& {
        return find_named(formats, "ending of a video", ending_of(path));
    });
}

std::vector<std::string> encode_words(const VideoFormat& format, const Canvas& canvas, int quality,
                                      const std::string& out, const std::string& palette) {
    std::vector<std::string> words = input_words(canvas);
    if (format.has_palette) words.insert(words.end(), {"-i", file_word(palette)});
    if (format.halves_colour) add_words(words, halved_colour);
    add_words(words, format.arguments);
    if (format.quality > 0) add_words(words, cat("-quality ", quality));
    add_words(words, cat("-fflags +bitexact -flags:v +bitexact -f ", format.muxer));
    words.push_back(file_word(out));
    return words;
}

std::vector<std::string> palette_words(const Canvas& canvas, const std::string& out) {
    std::vector<std::string> words = input_words(canvas);
    add_words(words, "-vf palettegen -frames:v 1 -c:v png -f image2 -update 1");
    words.push_back(file_word(out));
    return words;
}

}  // namespace drape
