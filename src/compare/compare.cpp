#include "compare/compare.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/names.h"
#include "compare/flip.h"
#include "compare/metrics.h"
#include "compare/ssim.h"
#include "io/png.h"
#include "io/read_file.h"
#include "toml/keys.h"

namespace drape {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_file = std::uint64_t{16} << 30;  // [bytes]

enum class Kind { other, picture, cache };

Kind kind_of(const fs::path& file) {
    if (file.extension() == ".png") return Kind::picture;
    return is_readable_cache(file.string()) ? Kind::cache : Kind::other;
}

// What holds for one file.
struct Rules {
    Limits limits;
    std::vector<Rectangle> ignore;
    bool perceptual = false, hausdorff = false;
};

LimitFile limits_beside(const std::string& reference) {
    const fs::path path(reference);
    return read_limits(((fs::is_directory(path) ? path : path.parent_path()) / "compare.toml").string());
}

void put_over(Limits& limits, const Limits& more) {
    for (const auto& [key, limit] : more) limits[key] = limit;
}

Rules rules_for(const std::string& name, const LimitFile& file, const Asked& asked) {
    Rules rules{{}, file.ignore, asked.perceptual, asked.hausdorff};
    for (const Metric& metric : metrics())
        if (metric.usual) rules.limits[std::string(metric.key)] = *metric.usual;
    put_over(rules.limits, file.limits);
    for (const LimitFile::Special& special : file.special)
        if (special.file == name) put_over(rules.limits, special.limits);
    put_over(rules.limits, asked.limits);
    rules.ignore.insert(rules.ignore.end(), asked.ignore.begin(), asked.ignore.end());
    for (const auto& [key, limit] : rules.limits) {
        const std::string_view flag = metric_of(key).asked_by;
        rules.perceptual |= flag == "--perceptual";
        rules.hausdorff |= flag == "--hausdorff";
    }
    return rules;
}

Compared differing(Compared compared, std::string why) {
    compared.verdict = Verdict::different;
    compared.why = std::move(why);
    return compared;
}

// Every metric that has a limit against it.
Compared judged(Compared compared, const Limits& limits) {
    std::string why;
    for (const Metric& metric : metrics()) {
        const auto limit = limits.find(metric.key);
        const std::optional<double> value = metric.value(compared);
        if (!value || limit == limits.end() || !exceeds(metric, *value, limit->second)) continue;
        why += cat(why.empty() ? "" : ", ", metric_text(metric, *value), " ", metric.name, " (at ",
                   metric.at_least ? "least " : "most ", metric_text(metric, limit->second), ")");
    }
    if (!why.empty()) return differing(std::move(compared), std::move(why));
    compared.verdict = Verdict::within;
    return compared;
}

Compared pictures(Compared compared, const std::string& result, const std::string& reference,
                  const Rules& rules) {
    Image picture = read_png(result);
    const Image wanted = read_png(reference);
    if (picture.width != wanted.width || picture.height != wanted.height)
        return differing(std::move(compared), cat(picture.width, "x", picture.height, " pixels instead of ",
                                                  wanted.width, "x", wanted.height));
    in_context(reference, [&] { ignore(picture, wanted, rules.ignore); });
    if (picture.rgb == wanted.rgb) return compared;
    compared.picture = picture_difference(picture, wanted);
    if (rules.perceptual) compared.perceived = {ssim(picture, wanted), flip(picture, wanted).mean()};
    return judged(std::move(compared), rules.limits);
}

Compared caches(Compared compared, const std::string& result, const std::string& reference,
                const Rules& rules) {
    const Cache cache = read_cache(result), wanted = read_cache(reference);
    const auto vertices = [](const Cache& c) { return c.samples.empty() ? 0 : c.samples.front().cols(); };
    const auto hausdorff = [&] {
        return rules.hausdorff ? std::optional(largest_hausdorff(cache, wanted)) : std::nullopt;
    };
    if (vertices(cache) != vertices(wanted)) {
        const std::optional<double> covering = hausdorff();
        return differing(
            std::move(compared),
            cat(vertices(cache), " vertices instead of ", vertices(wanted),
                covering ? cat(", ", metric_text(metric_of("hausdorff"), *covering), " Hausdorff")
                         : std::string()));
    }
    const CacheDifference& apart = compared.cache.emplace(cache_difference(cache, wanted));
    if (cache.samples.size() != wanted.samples.size())
        return differing(std::move(compared),
                         cat(cache.samples.size(), " samples instead of ", wanted.samples.size()));
    if (apart.from < 0 && cache.times == wanted.times) {
        compared.cache.reset();
        return compared;
    }
    if (cache.times != wanted.times) return differing(std::move(compared), "its samples are of other times");
    compared.cache->hausdorff_m = hausdorff();
    compared = judged(std::move(compared), rules.limits);
    if (!compared.passed())
        compared.why += cat(" in sample ", compared.cache->sample, ", vertex ", compared.cache->vertex,
                            " is furthest off; the first difference is in sample ", compared.cache->from);
    return compared;
}

Compared files(const std::string& name, const std::string& result, const std::string& reference,
               const Rules& rules) {
    Compared compared;
    compared.name = name;
    if (read_file(result, largest_file) == read_file(reference, largest_file)) return compared;
    return kind_of(reference) == Kind::picture ? pictures(std::move(compared), result, reference, rules)
                                               : caches(std::move(compared), result, reference, rules);
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

Comparison folders(const std::string& result, const std::string& reference, const LimitFile& limits,
                   const Asked& asked) {
    const std::set<std::string> ours = comparable_names(result), wanted = comparable_names(reference);
    std::set<std::string> all = ours;
    all.insert(wanted.begin(), wanted.end());
    if (all.empty())
        throw Error(
            cat(result, " and ", reference, ": nothing to compare (frame_*.png, *.pc2, *.mdd, *.glb)"));
    for (const LimitFile::Special& special : limits.special)
        if (!all.contains(special.file))
            fail(special.place, unknown_name("file", special.file, {all.begin(), all.end()}));
    Comparison comparison{{}, rules_for("", limits, asked).limits};
    for (const std::string& name : all) {
        if (ours.contains(name) && wanted.contains(name))
            comparison.files.push_back(files(name, (fs::path(result) / name).string(),
                                             (fs::path(reference) / name).string(),
                                             rules_for(name, limits, asked)));
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

Comparison compare(const std::string& result, const std::string& reference, const Asked& asked) {
    for (const std::string& operand : {result, reference})
        if (!fs::exists(operand)) throw Error(cat(operand, ": no such file or folder"));
    if (fs::is_directory(result) != fs::is_directory(reference))
        throw Error(cat(result, " and ", reference, ": a file against a folder (two of a kind)"));
    const LimitFile limits = limits_beside(reference);
    if (fs::is_directory(result)) return folders(result, reference, limits, asked);
    for (const std::string& operand : {result, reference})
        if (kind_of(operand) == Kind::other)
            throw Error(cat(operand, ": not a picture or a cache (.png, .pc2, .mdd, .glb)"));
    if (kind_of(result) != kind_of(reference))
        throw Error(cat(result, " and ", reference, ": a picture against a cache (two of a kind)"));
    const std::string name = fs::path(result).filename().string();
    const std::string wanted = fs::path(reference).filename().string();
    const Rules rules = rules_for(wanted, limits, asked);
    return {{files(name, result, reference, rules)}, rules.limits};
}

ComparedPaths paths_of(const Compared& file, const std::string& result, const std::string& reference,
                       const Asked& asked) {
    const bool folder = fs::is_directory(reference);
    ComparedPaths paths{folder ? (fs::path(result) / file.name).string() : result,
                        folder ? (fs::path(reference) / file.name).string() : reference,
                        limits_beside(reference).ignore};
    paths.ignore.insert(paths.ignore.end(), asked.ignore.begin(), asked.ignore.end());
    return paths;
}

}  // namespace drape
