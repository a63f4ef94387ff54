// What ffprobe says of a video, and the frames that are in it.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "base/image.h"

namespace drape::test {

inline std::string output_of(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string out;
    char chunk[4096];
    for (size_t got = 0; (got = fread(chunk, 1, sizeof chunk, pipe.get())) > 0;) out.append(chunk, got);
    return out;
}

// Says so where a test cannot run.
inline bool skipped_without_ffmpeg() {
    static const bool installed =
        std::system("ffmpeg -version > /dev/null 2>&1 && ffprobe -version > /dev/null 2>&1") == 0;
    if (!installed) WARN("skipped: ffmpeg and ffprobe are not installed");
    return !installed;
}

// "key=value" lines of the first stream, and of its container.
inline std::string probed(const std::string& file) {
    return output_of("ffprobe -v error -count_frames -show_streams -show_format '" + file + "' 2>&1");
}

// Value of the first line "key=..."; "" if there is none.
inline std::string value_of(const std::string& lines, const std::string& key) {
    const size_t at = ("\n" + lines).find("\n" + key + "=");
    if (at == std::string::npos) return "";
    const size_t begin = at + key.size() + 1;
    return lines.substr(begin, lines.find('\n', begin) - begin);
}

// The `k`th frame of a video, decoded by ffmpeg, whose quick way to RGB would be up to 1.6 levels too dark.
inline Image decoded_frame(const std::string& file, int k, int width, int height) {
    const std::string bytes = output_of(
        "ffmpeg -v error -i '" + file + "' -vf 'select=eq(n\\," + std::to_string(k) +
        "),scale=flags=accurate_rnd+full_chroma_int' -frames:v 1 -f rawvideo -pix_fmt rgb24 - 2>/dev/null");
    Image image(width, height);
    if (bytes.size() == image.rgb.size()) std::copy(bytes.begin(), bytes.end(), image.rgb.begin());
    return image;
}

// A variable of the environment, as it was before at the end.
class Environment {
public:
    Environment(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~Environment() { setenv(name_, before_.c_str(), 1); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    const char* name_;
    std::string before_;
};

}  // namespace drape::test
