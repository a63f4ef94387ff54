// What pictures and caches tell together.
#include <algorithm>

#include "base/error.h"
#include "compare/compared.h"

namespace drape {

namespace {

bool is_cache(const Compared& file) {
    return !file.name.ends_with(".png");
}

}  // namespace

std::string cause_of(const Comparison& comparison) {
    const Compared *cache = nullptr, *picture = nullptr;
    for (const Compared& file : comparison.files) {
        if (file.verdict == Verdict::missing || file.verdict == Verdict::added) continue;
        const bool changed = file.verdict == Verdict::different;
        const Compared*& kept = is_cache(file) ? cache : picture;
        if (!kept || (changed && kept->verdict != Verdict::different)) kept = &file;
    }
    if (!cache || !picture || picture->verdict != Verdict::different) return "";
    if (cache->verdict != Verdict::different)
        return "the positions are the same: only the look changed (light, camera, material, renderer)";
    return cat("the simulation changed: positions differ",
               cache->cache ? cat(" from sample ", cache->cache->from) : std::string());
}

}  // namespace drape
