#include "compare/compare.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "io/png.h"
#include "io/read_file.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_file = std::uint64_t{16} << 30;  // [bytes]

enum class Kind { other, picture, cache };

Kind kind_of(const fs::path& file) {
    if (file.extension() == ".png") return Kind::picture;
    if (file.extension() == ".pc2" || file.extension() == ".mdd") return Kind::cache;
    return Kind::other;
}

Compared judged(Compared compared, bool within, std::string why) {
    compared.verdict = within ? Verdict::within : Verdict::different;
    if (!within) compared.why = std::move(why);
    return compared;
}

Compared pictures(Compared compared, const std::string& result, const std::string& reference,
                  const Gate& gate) {
    const Image picture = read_png(result), wanted = read_png(reference);
    if (picture.width != wanted.width || picture.height != wanted.height)
        return judged(
            compared, false,
            cat(picture.width, "x", picture.height, " pixels instead of ", wanted.width, "x", wanted.height));
    if (picture.rgb == wanted.rgb) return compared;
    const PictureDifference apart = picture_difference(picture, wanted);
    compared.picture = apart;
    return judged(
        compared, apart.share_over <= gate.share_over && apart.mean_levels <= gate.mean_levels,
        cat(100 * apart.share_over, " % of pixels differ by more than 8 levels, ", apart.mean_levels,
            " levels in the mean (at most ", 100 * gate.share_over, " % and ", gate.mean_levels, ")"));
}

Compared caches(Compared compared, const std::string& result, const std::string& reference,
                const Gate& gate) {
    const Cache cache = read_cache(result), wanted = read_cache(reference);
    const auto vertices = [](const Cache& c) { return c.samples.empty() ? 0 : c.samples.front().cols(); };
    if (vertices(cache) != vertices(wanted))
        return judged(compared, false, cat(vertices(cache), " vertices instead of ", vertices(wanted)));
    const CacheDifference apart = cache_difference(cache, wanted);
    compared.cache = apart;
    if (cache.samples.size() != wanted.samples.size())
        return judged(compared, false,
                      cat(cache.samples.size(), " samples instead of ", wanted.samples.size()));
    if (apart.from < 0 && cache.times == wanted.times) return compared;
    if (cache.times != wanted.times) return judged(compared, false, "its samples are of other times");
    return judged(compared, apart.rms_m <= gate.rms_m,
                  cat("sample ", apart.sample, " is ", apart.rms_m, " m off in the RMS (at most ", gate.rms_m,
                      "), vertex ", apart.vertex, " up to ", apart.most_m,
                      " m; the first difference is in sample ", apart.from));
}

Compared files(const std::string& name, const std::string& result, const std::string& reference,
               const Gate& gate) {
    Compared compared;
    compared.name = name;
    if (read_file(result, largest_file) == read_file(reference, largest_file)) return compared;
    return kind_of(reference) == Kind::picture ? pictures(compared, result, reference, gate)
                                               : caches(compared, result, reference, gate);
}

std::set<std::string> comparable_names(const std::string& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const Kind kind = kind_of(entry.path());
        if (kind == Kind::cache || (kind == Kind::picture && name.starts_with("frame_"))) names.insert(name);
    }
    return names;
}

Comparison folders(const std::string& result, const std::string& reference, const Gate& gate) {
    const std::set<std::string> ours = comparable_names(result), wanted = comparable_names(reference);
    std::set<std::string> all = ours;
    all.insert(wanted.begin(), wanted.end());
    if (all.empty())
        throw Error(cat(result, " and ", reference, ": nothing to compare (frame_*.png, *.pc2, *.mdd)"));
    Comparison comparison;
    for (const std::string& name : all) {
        if (ours.contains(name) && wanted.contains(name))
            comparison.files.push_back(
                files(name, (fs::path(result) / name).string(), (fs::path(reference) / name).string(), gate));
        else if (wanted.contains(name))
            comparison.files.push_back(
                {.name = name, .verdict = Verdict::missing, .why = "only in the reference"});
        else
            comparison.files.push_back(
                {.name = name, .verdict = Verdict::added, .why = "not in the reference"});
    }
    return comparison;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
    constexpr std::array<std::string_view, 5> names{"identical", "within", "different", "missing", "added"};
    return names[static_cast<size_t>(verdict)];
}

int Comparison::count(Verdict verdict) const {
    return static_cast<int>(std::count_if(files.begin(), files.end(),
                                          [&](const Compared& file) { return file.verdict == verdict; }));
}

bool Comparison::passed() const {
    return count(Verdict::identical) + count(Verdict::within) == static_cast<int>(files.size());
}

Comparison compare(const std::string& result, const std::string& reference, const Gate& gate) {
    for (const std::string& operand : {result, reference})
        if (!fs::exists(operand)) throw Error(cat(operand, ": no such file or folder"));
    if (fs::is_directory(result) != fs::is_directory(reference))
        throw Error(cat(result, " and ", reference, ": a file against a folder (two of a kind)"));
    if (fs::is_directory(result)) return folders(result, reference, gate);
    for (const std::string& operand : {result, reference})
        if (kind_of(operand) == Kind::other)
            throw Error(cat(operand, ": not a picture or a cache (.png, .pc2, .mdd)"));
    if (kind_of(result) != kind_of(reference))
        throw Error(cat(result, " and ", reference, ": a picture against a cache (two of a kind)"));
    return {{files(fs::path(result).filename().string(), result, reference, gate)}};
}

}  // namespace drape
