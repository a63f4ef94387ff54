#include "scene/changed_keys.h"

#include <algorithm>

#include "base/error.h"
#include "toml/value.h"

namespace drape {

namespace {

bool same_number(double a, double b) {
    return a == b || (a != a && b != b);
}

bool is_same(const Value& a, const Value& b) {
    return a.kind == b.kind && a.key == b.key && a.boolean == b.boolean && a.integer == b.integer &&
           same_number(a.real, b.real) && a.text == b.text &&
           std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), is_same);
}

// numbers and texts of an array are no keys of their own
bool holds_tables(const Value& value) {
    return value.kind == Value::Kind::table || (value.kind == Value::Kind::array && !value.items.empty() &&
                                                value.items.front().kind == Value::Kind::table);
}

void compare(const Value& before, const Value& now, const std::string& key,
             std::vector<std::string>& changed) {
    if (is_same(before, now)) return;
    const bool arrays = now.kind == Value::Kind::array;
    if (before.kind != now.kind || !holds_tables(now) || !holds_tables(before) ||
        (arrays && before.items.size() != now.items.size())) {
        changed.push_back(key);
        return;
    }
    const auto within = [&](const auto& name) { return key.empty() ? cat(name) : cat(key, ".", name); };
    for (size_t i = 0; i < now.items.size(); ++i) {
        const Value* old = arrays ? &before.items[i] : before.find(now.items[i].key);
        const std::string name = arrays ? within(i) : within(now.items[i].key);
        if (old)
            compare(*old, now.items[i], name, changed);
        else
            changed.push_back(name);
    }
    if (arrays) return;
    for (const Value& old : before.items)
        if (!now.find(old.key)) changed.push_back(within(old.key));
}

}  // namespace

std::vector<std::string> changed_keys(std::string_view before, std::string_view now) {
    std::vector<std::string> changed;
    compare(parse_toml(before, "before"), parse_toml(now, "now"), "", changed);
    return changed;
}

}  // namespace drape
