// TOML by toml++; the one file that knows it.

#include <toml++/toml.h>

#include <algorithm>

#include "base/error.h"
#include "toml/value.h"

namespace drape {

namespace {

Place place_of(const std::string& source, const toml::source_region& region) {
    return {cat(source, ":", region.begin.line, ":", region.begin.column)};
}

Value converted(const toml::node& node, const std::string& source) {
    Value value;
    value.place = place_of(source, node.source());
    if (const auto* table = node.as_table()) {
        value.kind = Value::Kind::table;
        for (const auto& [key, member] : *table) {
            value.items.push_back(converted(member, source));
            value.items.back().key = key.str();
            value.items.back().key_place = place_of(source, key.source());
        }
    } else if (const auto* array = node.as_array()) {
        value.kind = Value::Kind::array;
        for (const toml::node& item : *array) value.items.push_back(converted(item, source));
    } else if (const auto* text = node.as_string()) {
        value.kind = Value::Kind::text;
        value.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
        value.kind = Value::Kind::integer;
        value.integer = integer->get();
        value.real = static_cast<double>(integer->get());
    } else if (const auto* real = node.as_floating_point()) {
        value.kind = Value::Kind::real;
        value.real = real->get();
    } else if (const auto* boolean = node.as_boolean()) {
        value.kind = Value::Kind::boolean;
        value.boolean = boolean->get();
    } else {
        value.kind = Value::Kind::date;
    }
    return value;
}

// toml++ limits how deep arrays and inline tables nest but not how many parts a dotted key has, and both it
// and `converted` recurse over them. Multi-line strings are refused, so that quotes are told apart within a
// line.
void check_dotted_keys(std::string_view text, const std::string& source) {
    constexpr int most_dots = 32;
    int line = 1, dots = 0;
    char quote = 0;
    bool comment = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') {
            ++line;
            dots = 0;
            quote = 0;
            comment = false;
        } else if (comment) {
            continue;
        } else if (quote) {
            if (c == '\\' && quote == '"') ++i;
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            if (text.substr(i, 3) == std::string(3, c))
                throw Error(cat(source, ":", line, ": a multi-line string (none is taken)"));
            quote = c;
        } else if (c == '#') {
            comment = true;
        } else if (c == '.') {
            if (++dots > most_dots)
                throw Error(cat(source, ":", line, ": a key of more than ", most_dots, " parts"));
        } else if (std::string_view("=,{}[]").find(c) != std::string_view::npos) {
            dots = 0;
        }
    }
}

}  // namespace

Value parse_toml(std::string_view text, const std::string& source) {
    check_dotted_keys(text, source);
    try {
        return converted(toml::parse(text, source), source);
    } catch (const toml::parse_error& error) {
        std::string what(error.description());
        std::replace_if(
            what.begin(), what.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
        throw Error(place_of(source, error.source()).text + ": " + what);
    }
}

}  // namespace drape
