#include "video/encoder.h"

#include <filesystem>

#include "base/assert.h"
#include "base/error.h"
#include "picture/panes.h"

namespace drape {

namespace {

int even(int length) {
    return length + length % 2;
}

}  // namespace

Encoder::Encoder(const std::string& path, const Canvas& canvas, int quality)
    : path_(path),
      format_(format_of(path)),
      canvas_(canvas),
      quality_(quality > 0 ? quality : format_.quality),
      file_(path) {
    if (format_.halves_colour) canvas_ = {even(canvas.width), even(canvas.height), canvas.rate};
    if (format_.has_palette) {
        palette_.emplace(path + ".palette");
        start(palette_words(canvas_, palette_->temporary()));
    } else {
        start(encode_words(format_, canvas_, quality_, file_.temporary()));
    }
}

void Encoder::start(const std::vector<std::string>& words) {
    try {
        program_ = std::make_unique<PipedProgram>(words);
    } catch (const Error& error) {
        fail(error.what());
    }
}

void Encoder::add(const Image& frame) {
    const bool fits = frame.width == canvas_.width && frame.height == canvas_.height;
    DRAPE_ASSERT(fits || (frame.width <= canvas_.width && frame.height <= canvas_.height));
    const bool taken = program_->write(fits ? frame.rgb : extended(frame, canvas_.width, canvas_.height).rgb);
    if (taken) return;
    const std::string reason = program_->finish();
    fail(reason.empty() ? "ffmpeg ended before the last frame" : reason);
}

bool Encoder::another_pass() {
    if (!palette_ || palette_found_) return false;
    end_program();
    palette_found_ = true;
    start(encode_words(format_, canvas_, quality_, file_.temporary(), palette_->temporary()));
    return true;
}

std::uint64_t Encoder::end() {
    end_program();
    return std::filesystem::file_size(file_.temporary());
}

void Encoder::finish() {
    if (program_) end_program();
    file_.finish();
}

void Encoder::end_program() {
    if (const std::string reason = program_->finish(); !reason.empty()) fail(reason);
    cpu_seconds_ += program_->cpu_seconds();
    program_.reset();
}

void Encoder::fail(std::string reason) const {
    // ffmpeg knows the file by another name
    if (const std::string name = "file:" + file_.temporary(); reason.find(name) != std::string::npos)
        reason.replace(reason.find(name), name.size(), path_);
    throw Error(cat(path_, ": cannot write: ", reason), Exit::cannot_write);
}

}  // namespace drape
