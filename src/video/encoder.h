// Frames in, a video file out; ffmpeg, a program of its own, encodes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/image.h"
#include "io/output_file.h"
#include "video/format.h"
#include "video/piped_program.h"

namespace drape {

//     Encoder encoder("film.gif", {640, 360, 30});
//     do
//         for (const Image& frame : frames) encoder.add(frame);
//     while (encoder.another_pass());
//     encoder.finish();
//
// The file appears whole, by finish(), or not at all. What goes wrong is an Error (Exit::cannot_write)
// "FILE: cannot write: reason", ffmpeg's own last line where it has one.
class Encoder {
public:
    // The format goes by the path's ending; every frame has the canvas's size. `quality` 0: the format's own,
    // which a format that has none always takes.
    Encoder(const std::string& path, const Canvas& canvas, int quality = 0);

    void add(const Image& frame);
    // True where all frames are needed once more: those of a GIF, once its palette is found.
    bool another_pass();
    // Ends the encoding, before finish(): how large the file will be [bytes].
    std::uint64_t end();
    void finish();
    // What ffmpeg took, once finished [s].
    double cpu_seconds() const { return cpu_seconds_; }

private:
    void start(const std::vector<std::string>& words);
    void end_program();
    [[noreturn]] void fail(std::string reason) const;

    std::string path_;
    const VideoFormat& format_;
    Canvas canvas_;  // as ffmpeg gets it
    int quality_;
    OutputFile file_;
    std::optional<OutputFile> palette_;
    bool palette_found_ = false;
    std::unique_ptr<PipedProgram> program_;
    double cpu_seconds_ = 0;
};

}  // namespace drape
