#include "compare/limits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "compare/metrics.h"
#include "io/read_file.h"
#include "toml/keys.h"

namespace drape {

namespace {

constexpr std::uint64_t most_bytes = 1 << 20;  // of compare.toml
constexpr int most_pixels = 1 << 20;           // across or down

Limits limits_in(const Keys& keys) {
    Limits limits;
    for (const Metric& metric : metrics())
        if (const Value* value = keys.find(metric.key))
            limits[std::string(metric.key)] = as_number(
                *value, metric.key, {.unit = metric.unit == "m" ? "m" : "", .least = 0, .most = metric.most});
    return limits;
}

Rectangle rectangle_in(const Value& value) {
    const std::vector<Value>& items = as_array(value, "ignore: a rectangle X, Y, W, H", 4);
    const auto number = [&](size_t i, int least) {
        return as_integer(items[i], i < 2 ? "ignore: where a rectangle begins" : "ignore: a rectangle's size",
                          least, most_pixels);
    };
    return {number(0, 0), number(1, 0), number(2, 1), number(3, 1)};
}

}  // namespace

void add_limit(Limits& limits, const std::string& text) {
    const size_t equals = std::min(text.find('='), text.size());
    const Metric& metric =
        in_context("--limit " + text, [&]() -> const Metric& { return metric_of(text.substr(0, equals)); });
    double value = 0;
    const char* const begin = text.data() + std::min(equals + 1, text.size());
    const auto [stop, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size() || !(value >= 0 && value <= metric.most))
        throw Error(
            cat(metric.key, ": expected a number ",
                std::isinf(metric.most) ? std::string("of at least 0") : cat("from 0 to ", metric.most),
                metric.unit == "m" ? " in metres" : "", ", found \"",
                text.substr(equals + (equals < text.size())), "\""));
    limits[std::string(metric.key)] = value;
}

Rectangle rectangle_of(const std::string& text) {
    std::array<int, 4> part{};
    const char *at = text.data(), *const end = at + text.size();
    for (size_t i = 0; i < part.size(); ++i) {
        const auto [stop, error] = std::from_chars(at, end, part[i]);
        const bool last = i + 1 == part.size();
        const bool ends = last ? stop == end : stop != end && *stop == ',';
        if (error != std::errc() || !ends || part[i] < (i < 2 ? 0 : 1) || part[i] > most_pixels)
            throw Error(cat("--ignore ", text, ": expected X,Y,W,H in pixels, such as 0,0,200,40"));
        at = stop + 1;
    }
    return {part[0], part[1], part[2], part[3]};
}

void ignore(Image& picture, const Image& reference, const std::vector<Rectangle>& rectangles) {
    for (const Rectangle& r : rectangles) {
        if (r.x >= picture.width || r.y >= picture.height)
            throw Error(cat("to be ignored: ", r.x, ",", r.y, ",", r.width, ",", r.height,
                            ": outside of the picture (", picture.width, "x", picture.height, " pixels)"));
        const int right = std::min(r.x + r.width, picture.width);
        for (int y = r.y; y < std::min(r.y + r.height, picture.height); ++y)
            std::copy(reference.pixel(r.x, y), reference.pixel(r.x, y) + 3 * (right - r.x),
                      picture.pixel(r.x, y));
    }
}

LimitFile read_limits(const std::string& path) {
    LimitFile file;
    if (!std::filesystem::exists(path)) return file;
    const Value root = parse_toml(read_file(path, most_bytes), path);
    std::vector<std::string> known = metric_keys();
    known.insert(known.end(), {"ignore", "file"});
    const Keys keys(root, "compare.toml", known);
    file.limits = limits_in(keys);
    if (const Value* rectangles = keys.find("ignore"))
        for (const Value& rectangle : as_array(*rectangles, "ignore"))
            file.ignore.push_back(rectangle_in(rectangle));
    if (const Value* named = keys.find("file")) {
        if (named->kind != Value::Kind::table)
            fail(named->place, "file: expected tables such as [file.\"frame_0001.png\"], found ",
                 description_of(*named));
        for (const Value& one : named->items)
            file.special.push_back({one.key, one.key_place,
                                    limits_in(Keys(one, cat("file.", in_quotes(one.key)), metric_keys()))});
    }
    return file;
}

}  // namespace drape
