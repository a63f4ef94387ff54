#include "scene/overrides.h"

#include <array>
#include <charconv>

#include "base/error.h"
#include "toml/keys.h"

namespace drape {

namespace {

// "cloth[0].fabric" -> cloth, 0, fabric
std::vector<std::string> parts_of(std::string_view key, const Place& place) {
    constexpr size_t most_parts = 32;
    std::vector<std::string> parts(1);
    for (size_t i = 0; i < key.size(); ++i) {
        const bool closes = key[i] == ']';
        if (closes && i + 1 < key.size() && key[i + 1] != '.' && key[i + 1] != '[')
            fail(place, "expected . or [ after ]");
        if (key[i] == '.' || key[i] == '[')
            parts.emplace_back();
        else if (!closes)
            parts.back() += key[i];
    }
    for (const std::string& part : parts)
        if (part.empty()) fail(place, "an empty part in the key (write it as cloth.0.fabric=...)");
    if (parts.size() > most_parts) fail(place, "a key of more than ", most_parts, " parts");
    return parts;
}

void put_in_place(Value& value, const Place& place) {
    value.place = value.key_place = place;
    for (Value& item : value.items) put_in_place(item, place);
}

Value parse_value(const std::string& text, const Place& place) {
    const auto as_plain_text = [&] {
        Value value;
        value.kind = Value::Kind::text;
        value.text = text;
        return value;
    };
    // a second line would be a second key
    const bool one_line = text.find('\n') == std::string::npos;
    if (!text.empty() && one_line) {
        try {
            return parse_toml("value = " + text, "--set").items.front();
        } catch (const Error&) {
            if (std::string_view("[{\"'").find(text[0]) == std::string_view::npos) return as_plain_text();
        }
    }
    fail(place, in_quotes(text), " is not a TOML value");
}

// Values that a scene may write in short, and the key that the short form stands for.
struct ShortForm {
    std::string_view key, stands_for;
};
constexpr std::array short_forms{ShortForm{"fabric", "preset"}, ShortForm{"altitude", "mode"},
                                 ShortForm{"membrane", "kind"}, ShortForm{"bending", "value"}};

// fabric = "silk" as fabric = { preset = "silk" }, so that another key can join it
void write_in_full(Value& value) {
    for (const ShortForm& form : short_forms) {
        if (value.key != form.key || value.kind == Value::Kind::table) continue;
        Value full;
        full.kind = Value::Kind::table;
        full.key = value.key;
        full.place = value.place;
        full.key_place = value.key_place;
        value.key = form.stands_for;
        full.items.push_back(std::move(value));
        value = std::move(full);
        return;
    }
}

// the item of `parent` that `part` names: an element that is there, or a key, made if it is missing
Value& item_of(Value& parent, const std::string& part, const Place& place) {
    if (parent.kind == Value::Kind::array) {
        size_t index = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), index);
        if (error != std::errc() || end != part.data() + part.size() || index >= parent.items.size())
            fail(place, "no element ", in_quotes(part), " in an array of ", parent.items.size(),
                 " (they count from 0)");
        return parent.items[index];
    }
    write_in_full(parent);
    if (parent.kind != Value::Kind::table)
        fail(place, "no key ", in_quotes(part), " in ", description_of(parent), ", which is not a table");
    if (Value* item = parent.find(part)) return *item;
    Value& made = parent.items.emplace_back();
    made.key = part;
    made.place = made.key_place = place;
    return made;
}

}  // namespace

void apply_override(Value& scene, const std::string& assignment) {
    const std::string shown = in_quotes(assignment);
    const Place place{"--set " + shown.substr(1, shown.size() - 2)};
    const size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) fail(place, "expected KEY=VALUE");

    Value* target = &scene;
    for (const std::string& part : parts_of(std::string_view(assignment).substr(0, equals), place))
        target = &item_of(*target, part, place);

    Value value = parse_value(assignment.substr(equals + 1), place);
    put_in_place(value, place);
    value.key = target->key;
    *target = std::move(value);
}

}  // namespace drape
