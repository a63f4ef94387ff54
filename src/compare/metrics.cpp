#include "compare/metrics.h"

#include <array>
#include <limits>

#include "base/error.h"
#include "base/names.h"
#include "base/numbers.h"

namespace drape {

namespace {

using Value = std::optional<double>;

template <auto field>
Value of_picture(const Compared& file) {
    return file.picture ? Value((*file.picture).*field) : Value();
}

template <auto field>
Value of_eye(const Compared& file) {
    return file.perceived ? Value((*file.perceived).*field) : Value();
}

template <auto field>
Value of_cache(const Compared& file) {
    return file.cache ? Value((*file.cache).*field) : Value();
}

constexpr double any_length = std::numeric_limits<double>::infinity();

// The usual limits lie between what was measured: the noise of other processors is up to 5 pixels of 921600
// over 8 levels and a mean of 4e-4 levels, a bump of 1 mm 52 pixels and 3.5e-3. Positions: ten roundings of a
// cache's single precision at a metre.
constexpr std::array table{
    Metric{.key = "share",
           .name = "of pixels over 8 levels",
           .unit = "%",
           .says = "pixels that differ by more than 8 levels in any channel",
           .value = of_picture<&PictureDifference::share_over>,
           .usual = 2e-5},
    Metric{.key = "mean",
           .name = "in the mean",
           .unit = "levels",
           .says = "mean absolute difference over all pixels and channels",
           .value = of_picture<&PictureDifference::mean_levels>,
           .usual = 2e-3,
           .most = 255},
    Metric{.key = "off_edges",
           .name = "over 8 levels off moved edges",
           .unit = "%",
           .says = "the same pixels without those that an edge moved by up to a pixel explains",
           .value = of_picture<&PictureDifference::share_off_edges>},
    Metric{.key = "density",
           .name = "over 8 levels in one window",
           .unit = "%",
           .says =
               "the same pixels in the window of 32 x 32 with most of them: noise is thin, a change is dense",
           .value = of_picture<&PictureDifference::density>},
    Metric{.key = "ssim",
           .name = "SSIM",
           .says = "structural similarity of grey levels, 1 for the same picture",
           .value = of_eye<&Perceived::ssim>,
           .at_least = true,
           .asked_by = "--perceptual"},
    Metric{.key = "flip",
           .name = "FLIP",
           .says = "what an eye notices that flips between the two, 0 to 1",
           .value = of_eye<&Perceived::flip>,
           .asked_by = "--perceptual"},
    Metric{.key = "rms",
           .name = "RMS",
           .unit = "m",
           .says = "positions of the worst sample, root mean square over vertices",
           .value = of_cache<&CacheDifference::rms_m>,
           .usual = 1e-6,
           .most = any_length},
    Metric{.key = "largest",
           .name = "of one vertex",
           .unit = "m",
           .says = "the vertex furthest away, in any sample",
           .value = of_cache<&CacheDifference::most_m>,
           .most = any_length},
    Metric{.key = "hausdorff",
           .name = "Hausdorff",
           .unit = "m",
           .says = "how far the vertices are from covering each other, whichever stands for which",
           .value = [](const Compared& file) { return file.cache ? file.cache->hausdorff_m : Value(); },
           .most = any_length,
           .asked_by = "--hausdorff"},
};

}  // namespace

std::span<const Metric> metrics() {
    return table;
}

std::vector<std::string> metric_keys() {
    std::vector<std::string> keys;
    for (const Metric& metric : table) keys.emplace_back(metric.key);
    return keys;
}

const Metric& metric_of(std::string_view key) {
    for (const Metric& metric : table)
        if (metric.key == key) return metric;
    throw Error(unknown_name("limit", key, metric_keys()));
}

bool exceeds(const Metric& metric, double value, double limit) {
    return metric.at_least ? !(value >= limit) : !(value <= limit);
}

std::string metric_text(const Metric& metric, double value) {
    if (metric.unit == "%") return cat(figure(100 * value), " %");
    if (metric.unit == "m") return value == 0 ? "0 m" : length_text(value);
    if (metric.unit == "") return figure(value, 4);
    return cat(figure(value), " ", metric.unit);
}

}  // namespace drape
