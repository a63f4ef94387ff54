// A parsed TOML file: a tree of values, each knowing where it stands, in the order of the file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "toml/place.h"

namespace drape {

struct Value {
    enum class Kind { boolean, integer, real, text, date, array, table };

    Kind kind = Kind::table;
    bool boolean = false;
    std::int64_t integer = 0;
    double real = 0;           // of an integer too
    std::string text;          // of Kind::text
    std::vector<Value> items;  // of an array; of a table too, each with its key
    Place place;

    // inside a table only
    std::string key;
    Place key_place;

    const Value* find(std::string_view wanted) const;  // the item with this key; null if there is none
    Value* find(std::string_view wanted);
};

// Parses TOML; `source` names it in places. Throws Error "SOURCE:LINE:COL: ...".
Value parse_toml(std::string_view text, const std::string& source);

// What stands there, for "expected ..., found ...": `the text "cotton"`, "an array of 2".
std::string description_of(const Value& value);

// In double quotes, cut if long, control characters escaped: safe in a message of one line.
std::string in_quotes(std::string_view text);

}  // namespace drape
