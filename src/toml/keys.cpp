#include "toml/keys.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/assert.h"

namespace drape {

namespace {

struct Suffix {
    std::string_view name, unit;
    double scale;  // to `unit`
};
constexpr std::array suffixes{Suffix{"m", "m", 1},     Suffix{"cm", "m", 1e-2}, Suffix{"mm", "m", 1e-3},
                              Suffix{"um", "m", 1e-6}, Suffix{"km", "m", 1e3},  Suffix{"s", "s", 1},
                              Suffix{"ms", "s", 1e-3}, Suffix{"us", "s", 1e-6}, Suffix{"min", "s", 60}};

// of any number, and the inverse of the least where it must be over 0: what is made of them stays finite
constexpr double largest = 1e15;

// what a quantity in this unit may be written as
std::string_view expected_number(const Quantity& quantity) {
    if (quantity.unit == "m") return "a length, such as 0.02 or \"2 cm\"";
    if (quantity.unit == "s") return "a time, such as 0.5 or \"500 ms\"";
    return "a number";
}

[[noreturn]] void fail_type(const Value& value, std::string_view name, std::string_view expected) {
    fail(value.place, name, ": expected ", expected, ", found ", description_of(value));
}

// "3 mm" in metres, "20 ms" in seconds
double parse_with_unit(const Value& value, std::string_view name, const Quantity& quantity) {
    const std::string& text = value.text;
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    std::string_view unit(end, static_cast<size_t>(text.data() + text.size() - end));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    const auto suffix = std::find_if(suffixes.begin(), suffixes.end(), [&](const Suffix& candidate) {
        return candidate.name == unit && candidate.unit == quantity.unit;
    });
    if (error != std::errc() || suffix == suffixes.end()) {
        std::string units;
        for (const Suffix& known : suffixes)
            if (known.unit == quantity.unit) units += cat(units.empty() ? "" : ", ", known.name);
        fail(value.place, name, ": expected ", expected_number(quantity), ", found the text ",
             in_quotes(text), " (units: ", units, ")");
    }
    // 20 ms is 20 / 1000 s: dividing by a whole number rounds once, and to what 0.02 reads as
    return suffix->scale < 1 ? number / std::round(1 / suffix->scale) : number * suffix->scale;
}

std::string allowed(const Quantity& quantity) {
    const std::string unit = quantity.unit.empty() ? "" : cat(" ", quantity.unit);
    if (quantity.least == 0 && quantity.above_least && std::isinf(quantity.most)) return "positive";
    if (std::isinf(quantity.most))
        return cat(quantity.above_least ? "above " : "at least ", quantity.least, unit);
    if (quantity.above_least) return cat("above ", quantity.least, " and at most ", quantity.most, unit);
    return cat("from ", quantity.least, " to ", quantity.most, unit);
}

// a word of the user's, cut and clean, to be put into quotes
std::string shown(std::string_view word) {
    const std::string text = in_quotes(word);
    return text.substr(1, text.size() - 2);
}

}  // namespace

bool as_boolean(const Value& value, std::string_view name) {
    if (value.kind != Value::Kind::boolean) fail_type(value, name, "true or false");
    return value.boolean;
}

double as_number(const Value& value, std::string_view name, const Quantity& quantity) {
    const bool takes_unit = quantity.unit == "m" || quantity.unit == "s";
    double number = value.real;
    if (value.kind == Value::Kind::text && takes_unit)
        number = parse_with_unit(value, name, quantity);
    else if (value.kind != Value::Kind::integer && value.kind != Value::Kind::real)
        fail_type(value, name, expected_number(quantity));
    if (!std::isfinite(number)) fail(value.place, name, " must be a finite number, got ", number);
    const std::string unit = quantity.unit.empty() ? "" : cat(" ", quantity.unit);
    if (std::abs(number) > largest)
        fail(value.place, name, " must be from ", -largest, " to ", largest, unit, ", got ", number, unit);
    const bool above_zero = quantity.least == 0 && quantity.above_least;
    if (above_zero && number > 0 && number < 1 / largest)
        fail(value.place, name, " must be at least ", 1 / largest, unit, ", got ", number, unit);
    const bool too_low = quantity.above_least ? number <= quantity.least : number < quantity.least;
    if (too_low || number > quantity.most)
        fail(value.place, name, " must be ", allowed(quantity), ", got ", number, unit);
    return number;
}

int as_integer(const Value& value, std::string_view name, int least, int most) {
    if (value.kind != Value::Kind::integer) fail_type(value, name, "an integer");
    if (value.integer < least || value.integer > most) {
        const std::string range = most == std::numeric_limits<int>::max() ? cat("at least ", least)
                                                                          : cat("from ", least, " to ", most);
        fail(value.place, name, " must be ", range, ", got ", value.integer);
    }
    return static_cast<int>(value.integer);
}

const std::string& as_text(const Value& value, std::string_view name) {
    if (value.kind != Value::Kind::text) fail_type(value, name, "a text");
    return value.text;
}

const std::string& as_word(const Value& value, std::string_view name, const std::vector<std::string>& known) {
    const std::string& word = as_text(value, name);
    if (std::find(known.begin(), known.end(), word) == known.end())
        fail(value.place, unknown_name(name, shown(word), known));
    return word;
}

const std::vector<Value>& as_array(const Value& value, std::string_view name, int count) {
    if (count < 0) {
        if (value.kind != Value::Kind::array) fail_type(value, name, "an array");
    } else if (value.kind != Value::Kind::array || value.items.size() != static_cast<size_t>(count)) {
        fail_type(value, name, cat("an array of ", count));
    }
    return value.items;
}

Vec3 as_vector(const Value& value, std::string_view name, const Quantity& quantity) {
    const std::vector<Value>& items = as_array(value, name, 3);
    Vec3 result;
    for (int c = 0; c < 3; ++c) result[c] = as_number(items[static_cast<size_t>(c)], name, quantity);
    return result;
}

Keys::Keys(const Value& value, std::string owner, std::vector<std::string> known)
    : value_(value), owner_(std::move(owner)), known_(std::move(known)) {
    if (value.kind != Value::Kind::table) fail_type(value, owner_, "a table");
    for (const Value& item : value.items) {
        if (std::find(known_.begin(), known_.end(), item.key) != known_.end()) continue;
        fail(item.key_place, unknown_name(owner_ + " key", shown(item.key), known_));
    }
}

const Value* Keys::find(std::string_view key) const {
    DRAPE_ASSERT(std::find(known_.begin(), known_.end(), key) != known_.end());
    return value_.find(key);
}

const Value& Keys::need(std::string_view key) const {
    const Value* value = find(key);
    if (!value) fail(place(), owner_, ": ", key, " is missing");
    return *value;
}

void Keys::read(std::string_view key, bool& into) const {
    if (const Value* value = find(key)) into = as_boolean(*value, key);
}

void Keys::read(std::string_view key, double& into, const Quantity& quantity) const {
    if (const Value* value = find(key)) into = as_number(*value, key, quantity);
}

void Keys::read(std::string_view key, int& into, int least, int most) const {
    if (const Value* value = find(key)) into = as_integer(*value, key, least, most);
}

void Keys::read(std::string_view key, std::string& into) const {
    if (const Value* value = find(key)) into = as_text(*value, key);
}

void Keys::read(std::string_view key, Vec3& into, const Quantity& quantity) const {
    if (const Value* value = find(key)) into = as_vector(*value, key, quantity);
}

}  // namespace drape
