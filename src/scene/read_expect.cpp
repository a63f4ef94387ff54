// [expect]: what a run of the scene should come to.

#include "scene/read_parts.h"
#include "toml/keys.h"

namespace drape {

Expectation read_expect(const Value& value) {
    const Keys keys(value, "expect", {"outcome", "because", "largest_strain", "fastest"});
    Expectation expected;
    expected.outcome = as_word(keys.need("outcome"), "outcome", {"runs", "refused", "stops"});
    const bool runs = expected.outcome == "runs";
    if (const Value* because = keys.find("because")) {
        if (runs) fail(because->key_place, "because goes with refused or stops only (leave it out)");
        expected.because = as_text(*because, "because");
    }
    const auto read_bound = [&](std::string_view key, std::optional<double>& bound,
                                const Quantity& quantity) {
        const Value* given = keys.find(key);
        if (!given) return;
        if (!runs) fail(given->key_place, key, " goes with runs only (leave it out)");
        bound = as_number(*given, key, quantity);
    };
    read_bound("largest_strain", expected.largest_strain, not_negative());
    read_bound("fastest", expected.fastest, not_negative("m/s"));
    return expected;
}

}  // namespace drape
