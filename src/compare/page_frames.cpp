#include "compare/page_frames.h"

#include <algorithm>
#include <span>

#include "base/base64.h"
#include "base/error.h"
#include "base/markup.h"
#include "compare/flip.h"
#include "compare/heat.h"
#include "compare/ssim.h"
#include "io/png.h"
#include "io/read_file.h"
#include "picture/panes.h"
#include "picture/resize.h"

namespace drape {

namespace {

constexpr size_t most_full = 2, most_small = 12, most_passed = 2;
constexpr int small_width = 480;                                   // [pixels]
constexpr std::uint64_t largest_picture = std::uint64_t{1} << 30;  // [bytes]

// the order of how bad a frame is; one that has nothing to be measured comes after those that have
double badness(const Compared& file) {
    return file.picture ? file.picture->mean_levels : -1;
}

std::string figure_of(const std::string& kind, const std::string& caption, std::string_view png) {
    return cat("<figure class=\"", kind, "\"><img alt=\"", escaped(caption),
               "\" src=\"data:image/png;base64,", base64(png), "\"><figcaption>", escaped(caption),
               "</figcaption></figure>\n");
}

std::string figure_of(const std::string& kind, const std::string& caption, const Image& image) {
    const std::vector<std::uint8_t> png = encode_png(image);
    return figure_of(kind, caption, {reinterpret_cast<const char*>(png.data()), png.size()});
}

int factor_for(const Image& image, bool small) {
    return small ? (image.width + small_width - 1) / small_width : 1;
}

// The picture of a file: its own bytes at full size.
std::string side(const std::string& kind, const std::string& path, const Image& image, bool small) {
    const int factor = factor_for(image, small);
    if (factor == 1) return figure_of(kind, kind, read_file(path, largest_picture));
    return figure_of(kind, kind,
                     resized(image, std::max(image.width / factor, 1), std::max(image.height / factor, 1)));
}

}  // namespace

std::vector<ShownFrame> shown_frames(const Comparison& comparison) {
    std::vector<ShownFrame> failed, passed;
    for (size_t i = 0; i < comparison.files.size(); ++i) {
        const Compared& file = comparison.files[i];
        if (!file.name.ends_with(".png") || file.verdict == Verdict::identical) continue;
        (file.passed() ? passed : failed).push_back({i, true});
    }
    const auto worse = [&](const ShownFrame& a, const ShownFrame& b) {
        return badness(comparison.files[a.file]) > badness(comparison.files[b.file]);
    };
    const auto by_name = [](const ShownFrame& a, const ShownFrame& b) { return a.file < b.file; };
    const auto keep_worst = [&](std::vector<ShownFrame>& frames, size_t begin, size_t most) {
        if (frames.size() > begin)
            std::stable_sort(frames.begin() + static_cast<std::ptrdiff_t>(begin), frames.end(), worse);
        frames.resize(std::min(frames.size(), most));
    };
    keep_worst(failed, 1, most_full + most_small);
    for (size_t i = 0; i < std::min(failed.size(), most_full); ++i) failed[i].small = false;
    std::sort(failed.begin(), failed.end(), by_name);
    keep_worst(passed, 0, most_passed);
    std::sort(passed.begin(), passed.end(), by_name);
    failed.insert(failed.end(), passed.begin(), passed.end());
    return failed;
}

std::string frame_figures(Compared& file, const ComparedPaths& paths, bool small) {
    if (file.verdict == Verdict::added) return side("result", paths.result, read_png(paths.result), small);
    if (file.verdict == Verdict::missing)
        return side("reference", paths.reference, read_png(paths.reference), small);
    Image picture = read_png(paths.result);
    const Image reference = read_png(paths.reference);
    std::string figures =
        side("result", paths.result, picture, small) + side("reference", paths.reference, reference, small);
    if (picture.width != reference.width || picture.height != reference.height) return figures;
    ignore(picture, reference, paths.ignore);
    const ErrorMap seen = flip(picture, reference);
    file.perceived = {ssim(picture, reference), seen.mean()};
    const int factor = factor_for(picture, small);
    figures += figure_of("difference", "difference, times 16",
                         brightest(amplified_difference(picture, reference, 16), factor));
    // the map is blurred as the eye is: half the size shows as much
    return figures + figure_of("perception", "what an eye notices (FLIP)",
                               brightest(heat_map(seen), std::max(factor, 2)));
}

}  // namespace drape
