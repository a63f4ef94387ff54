// What kinds of video drape makes, and how ffmpeg is asked for them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape {

struct VideoFormat {
    std::string_view name;       // the file's ending
    std::string_view muxer;      // ffmpeg's name of the container
    std::string_view arguments;  // of the encoder, parted by spaces
    int quality;                 // of 100, where it may be chosen; else 0
    double most_rate;            // frames a second that its players show
    bool halves_colour;          // chroma at half the resolution: width and height must be even
    bool has_palette;            // of all frames, made in a pass before
};

struct Canvas {
    int width = 0, height = 0;  // [pixels]
    double rate = 30;           // [1/s]
};

// By the file's ending. Throws Error that names those there are.
const VideoFormat& format_of(const std::string& path);

// ffmpeg and its arguments: raw frames on its standard input become the video at `out`. The same frames give
// the same bytes whatever the number of cores: threads are counted, clocks and versions are left out.
// `quality` is only for a format that has one.
std::vector<std::string> encode_words(const VideoFormat& format, const Canvas& canvas, int quality,
                                      const std::string& out, const std::string& palette = "");

// The same frames become the PNG at `out` with the 256 colours that suit them best.
std::vector<std::string> palette_words(const Canvas& canvas, const std::string& out);

}  // namespace drape
