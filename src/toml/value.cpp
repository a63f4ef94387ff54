#include "toml/value.h"

#include <algorithm>

#include "base/error.h"
#include "base/plain_line.h"

namespace drape {

const Value* Value::find(std::string_view wanted) const {
    if (kind != Kind::table) return nullptr;
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const Value& item) { return item.key == wanted; });
    return found == items.end() ? nullptr : &*found;
}

Value* Value::find(std::string_view wanted) {
    return const_cast<Value*>(std::as_const(*this).find(wanted));
}

std::string description_of(const Value& value) {
    switch (value.kind) {
        case Value::Kind::boolean:
            return value.boolean ? "true" : "false";
        case Value::Kind::integer:
            return cat("the integer ", value.integer);
        case Value::Kind::real:
            return cat("the number ", value.real);
        case Value::Kind::text:
            return cat("the text ", in_quotes(value.text));
        case Value::Kind::date:
            return "a date or time";
        case Value::Kind::array:
            return cat("an array of ", value.items.size());
        case Value::Kind::table:
            return "a table";
    }
    return "";
}

std::string in_quotes(std::string_view text) {
    constexpr size_t longest = 60;
    return cat('"', plain_line(text.substr(0, longest)), text.size() > longest ? "...\"" : "\"");
}

}  // namespace drape
