// Checked access to the keys of a table: units, ranges, types, and the place of whatever is wrong.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/names.h"
#include "base/points.h"
#include "toml/value.h"

namespace drape {

// What a number means and may be. Lengths [m] and times [s] may be written with a unit: "3 mm", "20 ms".
struct Quantity {
    std::string_view unit = "";  // SI, as messages show it
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false;  // `least` itself is not allowed
};
constexpr Quantity any(std::string_view unit = "") {
    return {unit};
}
constexpr Quantity positive(std::string_view unit = "") {
    return {.unit = unit, .least = 0, .above_least = true};
}
constexpr Quantity not_negative(std::string_view unit = "") {
    return {.unit = unit, .least = 0};
}

// Values as what they should be; `name` names them in messages. They throw Error at the value's place.
bool as_boolean(const Value&, std::string_view name);
double as_number(const Value&, std::string_view name, const Quantity&);
int as_integer(const Value&, std::string_view name, int least, int most);
const std::string& as_text(const Value&, std::string_view name);
Vec3 as_vector(const Value&, std::string_view name, const Quantity&);
// an array; of exactly `count` values unless that is -1
const std::vector<Value>& as_array(const Value&, std::string_view name, int count = -1);

// one of these words; if it is not, the Error names the nearest one
const std::string& as_word(const Value&, std::string_view name, const std::vector<std::string>& known);

// The row of a table of kinds that the text names.
template <class Table>
const auto& as_kind(const Value& value, std::string_view name, const Table& table) {
    return find_named(table, name, as_word(value, name, names_of(table)));
}

// "PLACE: MESSAGE"
template <class... Parts>
[[noreturn]] void fail(const Place& place, const Parts&... parts) {
    throw Error(place.text + ": " + cat(parts...));
}

// The keys of one table.
class Keys {
public:
    // Throws Error unless `value` is a table all of whose keys are known. `owner` names it: "obstacle".
    Keys(const Value& value, std::string owner, std::vector<std::string> known);

    const Place& place() const { return value_.place; }
    const Value* find(std::string_view key) const;  // null: not given
    const Value& need(std::string_view key) const;  // throws Error if not given

    // each leaves `into` alone if the key is not given
    void read(std::string_view key, bool& into) const;
    void read(std::string_view key, double& into, const Quantity&) const;
    void read(std::string_view key, int& into, int least, int most) const;
    void read(std::string_view key, std::string& into) const;
    void read(std::string_view key, Vec3& into, const Quantity&) const;

private:
    const Value& value_;
    std::string owner_;
    std::vector<std::string> known_;
};

}  // namespace drape
