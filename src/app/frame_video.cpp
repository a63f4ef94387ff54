#include "app/frame_video.h"

#include <algorithm>

#include "app/frame_name.h"
#include "base/error.h"
#include "io/png.h"
#include "video/timeline.h"

namespace drape {

namespace {

Canvas shown_at(const VideoFormat& format, Canvas canvas) {
    canvas.rate = std::min(canvas.rate, format.most_rate);
    return canvas;
}

}  // namespace

FrameVideo::FrameVideo(const std::string& path, std::string folder, int first, int last, const Canvas& canvas)
    : folder_(std::move(folder)),
      canvas_(canvas),
      first_(first),
      last_(last),
      next_(first),
      shown_(thinned(play_order(last - first + 1, false, 1), canvas.rate, format_of(path).most_rate)),
      encoder_(path, shown_at(format_of(path), canvas)) {}

void FrameVideo::add(int frame, const Image& image) {
    take_pictures_before(frame);
    take(frame, image);
}

void FrameVideo::finish() {
    take_pictures_before(last_ + 1);
    if (encoder_.another_pass())
        for (const int k : shown_) encoder_.add(picture(first_ + k));
    encoder_.finish();
}

void FrameVideo::take_pictures_before(int frame) {
    while (next_ < frame) take(next_, picture(next_));
}

void FrameVideo::take(int frame, const Image& image) {
    next_ = frame + 1;
    if (std::binary_search(shown_.begin(), shown_.end(), frame - first_)) encoder_.add(image);
}

Image FrameVideo::picture(int frame) const {
    const std::string file = folder_ + frame_name(frame);
    Image image = read_png(file);
    if (image.width != canvas_.width || image.height != canvas_.height)
        throw Error(cat(file, ": is ", image.width, "x", image.height, " pixels, the video ", canvas_.width,
                        "x", canvas_.height));
    return image;
}

}  // namespace drape
