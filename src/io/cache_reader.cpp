#include "io/cache_reader.h"

#include <bit>
#include <cstdint>
#include <cstring>

#include "base/error.h"
#include "io/bytes.h"
#include "io/endings.h"
#include "io/glb_reader.h"
#include "io/read_file.h"

namespace drape {

namespace {

constexpr std::uint64_t largest_cache = 16ULL << 30;  // [bytes]

// What the header says, checked against what is there: the body must be exactly this long.
void check_size(const std::string& path, std::uint64_t size, std::uint64_t header, int points, int samples,
                std::uint64_t bytes_per_sample) {
    if (points < 1 || samples < 0)
        throw Error(
            cat(path, ": declares ", points, " points (at least 1) and ", samples, " samples (at least 0)"));
    const std::uint64_t per_sample = bytes_per_sample + 12 * static_cast<std::uint64_t>(points);
    const auto body = static_cast<std::uint64_t>(samples);
    if (body > size / per_sample + 1)
        throw Error(
            cat(path, ": declares ", samples, " samples of ", points, " points, more than the file holds"));
    if (size != header + body * per_sample)
        throw Error(cat(path, ": ", size, " bytes, but ", samples, " samples of ", points, " points need ",
                        header + body * per_sample));
}

Points sample_at(const char* bytes, int points, std::endian order) {
    Points sample(3, points);
    for (Eigen::Index i = 0; i < sample.size(); ++i)
        sample.data()[i] = static_cast<double>(number_at<float>(bytes + 4 * i, order));
    return sample;
}

Cache read_pc2(const std::string& path, std::string_view bytes) {
    constexpr auto order = std::endian::little;
    constexpr size_t header = 32;
    if (bytes.size() < header || std::memcmp(bytes.data(), "POINTCACHE2", 12) != 0)
        throw Error(cat(path, ": is not a PC2 cache (does not begin with POINTCACHE2)"));
    const int points = number_at<std::int32_t>(bytes.data() + 16, order);
    const double start = static_cast<double>(number_at<float>(bytes.data() + 20, order));
    const double rate = static_cast<double>(number_at<float>(bytes.data() + 24, order));
    const int samples = number_at<std::int32_t>(bytes.data() + 28, order);
    check_size(path, bytes.size(), header, points, samples, 0);
    Cache cache;
    for (size_t k = 0; k < static_cast<size_t>(samples); ++k) {
        cache.samples.push_back(
            sample_at(bytes.data() + header + 12 * k * static_cast<size_t>(points), points, order));
        cache.times.push_back(start + rate * static_cast<double>(k));
    }
    return cache;
}

Cache read_mdd(const std::string& path, std::string_view bytes) {
    constexpr auto order = std::endian::big;
    constexpr size_t header = 8;
    if (bytes.size() < header) throw Error(cat(path, ": is not an MDD cache (shorter than its header)"));
    const int samples = number_at<std::int32_t>(bytes.data(), order);
    const int points = number_at<std::int32_t>(bytes.data() + 4, order);
    check_size(path, bytes.size(), header, points, samples, 4);
    const char* positions = bytes.data() + header + 4 * static_cast<size_t>(samples);
    Cache cache;
    for (size_t k = 0; k < static_cast<size_t>(samples); ++k) {
        cache.samples.push_back(sample_at(positions + 12 * k * static_cast<size_t>(points), points, order));
        cache.times.push_back(static_cast<double>(number_at<float>(bytes.data() + header + 4 * k, order)));
    }
    return cache;
}

std::string check_ending(const std::string& path) {
    std::string ending = ending_of(path);
    if (!is_readable_cache(path))
        throw Error(
            cat(path, ": cannot read a cache that ends in \"", ending, "\" (known: .pc2, .mdd, .glb)"));
    return ending;
}

}  // namespace

bool is_readable_cache(const std::string& path) {
    const std::string ending = ending_of(path);
    return ending == ".pc2" || ending == ".mdd" || ending == ".glb";
}

Cache read_cache(const std::string& path) {
    check_ending(path);
    return read_cache_bytes(path, read_file(path, largest_cache));
}

Cache read_cache_bytes(const std::string& path, std::string_view bytes) {
    const std::string ending = check_ending(path);
    if (ending == ".glb") return read_glb(path, bytes);
    return ending == ".pc2" ? read_pc2(path, bytes) : read_mdd(path, bytes);
}

}  // namespace drape
