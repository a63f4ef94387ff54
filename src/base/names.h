// Tables of kinds are rows with a `name`; looking one up either succeeds or teaches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace drape {

// The number of single-letter edits (insert, delete, replace, swap neighbours) between two words.
int edit_distance(std::string_view a, std::string_view b);

// The known word nearest to `word`, or "" if none is near enough to be a slip of the fingers.
std::string nearest_name(std::string_view word, const std::vector<std::string>& known);

// "unknown obstacle "spere"; did you mean "sphere"? (known: plane, sphere)"
std::string unknown_name(std::string_view what, std::string_view word, const std::vector<std::string>& known);

// "one, two, three"
std::string joined(const std::vector<std::string>& words);

template <class Table>
std::vector<std::string> names_of(const Table& table) {
    std::vector<std::string> names;
    names.reserve(std::size(table));
    for (const auto& row : table) names.emplace_back(row.name);
    return names;
}

// The row called `name`. Throws Error naming the nearest known one.
template <class Table>
const auto& find_named(const Table& table, std::string_view what, std::string_view name) {
    for (const auto& row : table)
        if (row.name == name) return row;
    throw Error(unknown_name(what, name, names_of(table)));
}

}  // namespace drape
