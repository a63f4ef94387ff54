#include "scene/changed_keys.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("changed keys are named as --set takes them", "[scene]") {
    using Keys = std::vector<std::string>;
    const std::string before =
        "a = 1\nb = [1, 2]\n[c]\nd = \"x\"\n[[e]]\nf = { g = 1.5, h = true }\n[[e]]\nf = { g = nan }\n";
    const auto changed = [&](const std::string& now) { return changed_keys(before, now); };
    CHECK(changed(before).empty());
    CHECK(
        changed("a = 1\nb = [1, 2]\n\n[c]\nd = 'x' # the same\n[[e]]\nf = { g = 1.5, h = true }\n[[e]]\nf = "
                "{ g = nan }\n")
            .empty());
    CHECK(
        changed("a = 2\nb = [1, 3]\n[c]\nd = \"y\"\n[[e]]\nf = { g = 1.5, h = false }\n[[e]]\nf = { g = 2.0 "
                "}\n") == Keys{"a", "b", "c.d", "e.0.f.h", "e.1.f.g"});
    CHECK(changed("a = 1\nb = [1, 2]\n[c]\nd = \"x\"\nnew = 1\n[[e]]\nf = { g = 1.5, h = true }\n") ==
          Keys{"c.new", "e"});
    CHECK(changed("b = [1, 2]\nc = 7\n[[e]]\nf = 1\n[[e]]\nf = { g = nan }\n") == Keys{"c", "e.0.f", "a"});
}
