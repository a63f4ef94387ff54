// What comparing two results found.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/cache_difference.h"
#include "compare/limits.h"
#include "compare/picture_difference.h"

namespace drape {

enum class Verdict { identical, within, different, missing, added };

std::string_view verdict_name(Verdict verdict);

// What an eye would say; only where it is asked for.
struct Perceived {
    double ssim = 1;  // ssim.h
    double flip = 0;  // the mean of flip.h
};

struct Compared {
    std::string name = {};  // of the file
    Verdict verdict = Verdict::identical;
    std::string why = {};                           // it is different; else empty
    std::optional<PictureDifference> picture = {};  // where the pixels differ
    std::optional<Perceived> perceived = {};
    std::optional<CacheDifference> cache = {};  // where the positions do

    bool passed() const { return verdict == Verdict::identical || verdict == Verdict::within; }
};

struct Comparison {
    std::vector<Compared> files;  // by name
    Limits limits = {};           // of all files that compare.toml does not name

    int count(Verdict verdict) const;
    bool passed() const;  // every file is identical or within the limits
};

// What the pictures and caches of a comparison say together: whether the simulation or only its look changed;
// empty where they do not tell.
std::string cause_of(const Comparison& comparison);

}  // namespace drape
