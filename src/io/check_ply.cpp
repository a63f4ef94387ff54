#include "io/check_ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/names.h"
#include "io/bytes.h"

namespace drape {

namespace {

constexpr int most_corners =
    4096;  // cutting a polygon into triangles takes time as the square of its corners

template <class Number>
double read_as(const char* bytes, std::endian order) {
    return static_cast<double>(number_at<Number>(bytes, order));
}

struct NumberType {
    std::string_view name;
    size_t bytes;
    double (*read)(const char*, std::endian);
};

constexpr std::array number_types{
    NumberType{"char", 1, read_as<std::int8_t>},     NumberType{"int8", 1, read_as<std::int8_t>},
    NumberType{"uchar", 1, read_as<std::uint8_t>},   NumberType{"uint8", 1, read_as<std::uint8_t>},
    NumberType{"short", 2, read_as<std::int16_t>},   NumberType{"int16", 2, read_as<std::int16_t>},
    NumberType{"ushort", 2, read_as<std::uint16_t>}, NumberType{"uint16", 2, read_as<std::uint16_t>},
    NumberType{"int", 4, read_as<std::int32_t>},     NumberType{"int32", 4, read_as<std::int32_t>},
    NumberType{"uint", 4, read_as<std::uint32_t>},   NumberType{"uint32", 4, read_as<std::uint32_t>},
    NumberType{"float", 4, read_as<float>},          NumberType{"float32", 4, read_as<float>},
    NumberType{"double", 8, read_as<double>},        NumberType{"float64", 8, read_as<double>},
};

struct Property {
    std::string name;
    const NumberType* type = nullptr;
    const NumberType* count_type = nullptr;  // of a list; null: a single number
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    // no instance of it takes less; a number in a text takes a digit and a blank
    std::uint64_t least_bytes(bool text) const {
        std::uint64_t sum = 0;
        for (const Property& p : properties) sum += text ? 2 : (p.count_type ? p.count_type : p.type)->bytes;
        return std::max<std::uint64_t>(sum, 1);
    }
};

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (size_t at = line.find_first_not_of(" \t\r"); at < line.size();) {
        const size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        words.push_back(line.substr(at, end - at));
        at = std::min(line.find_first_not_of(" \t\r", end), line.size());
    }
    return words;
}

class PlyCheck {
public:
    PlyCheck(const std::string& path, std::string_view bytes) : path_(path), rest_(bytes) {}

    void run() {
        read_header();
        for (const Element& element : elements_) {
            const std::uint64_t most = rest_.size() / element.least_bytes(text_) + 1;
            if (element.count > most)
                fail(cat("declares ", element.count, " of element ", element.name,
                         ", the file can hold at most ", most));
            for (std::uint64_t i = 0; i < element.count; ++i) check_one(element, i);
        }
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(line_ > 0 ? cat(path_, ":", line_, ": ", what) : cat(path_, ": ", what));
    }

    void read_header() {
        for (bool ended = false; !ended;) {
            const size_t end = rest_.find('\n');
            ++line_;
            if (end == rest_.npos)
                fail(line_ == 1 ? "is not a PLY file" : "ends inside its header (no end_header)");
            const std::vector<std::string_view> words = words_of(rest_.substr(0, end));
            rest_.remove_prefix(end + 1);
            if (line_ == 1 && (words.size() != 1 || words[0] != "ply"))
                fail("is not a PLY file (does not begin with \"ply\")");
            if (line_ == 1 || words.empty()) continue;
            if (words[0] == "format") read_format(words);
            if (words[0] == "element") read_element(words);
            if (words[0] == "property") read_property(words);
            ended = words[0] == "end_header";
        }
        find_vertices();
        line_ = text_ ? line_ + 1 : 0;  // a binary body has no lines
    }

    void read_format(const std::vector<std::string_view>& words) {
        const std::string_view format = words.size() > 1 ? words[1] : "";
        text_ = format == "ascii";
        order_ = format == "binary_big_endian" ? std::endian::big : std::endian::little;
        if (!text_ && format != "binary_little_endian" && format != "binary_big_endian")
            fail(cat("unknown format \"", format.substr(0, 40),
                     "\" (known: ascii, binary_little_endian, binary_big_endian)"));
    }

    void read_element(const std::vector<std::string_view>& words) {
        if (words.size() != 3) fail("an element needs a name and a count");
        Element element{std::string(words[1]), 0, {}};
        const auto [end, trouble] =
            std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
        if (trouble != std::errc{} || end != words[2].data() + words[2].size())
            fail(cat("\"", words[2].substr(0, 40), "\" is not a count"));
        if (element.count > std::numeric_limits<int>::max())
            fail(cat("declares ", element.count, " of element ", element.name, " (at most ",
                     std::numeric_limits<int>::max(), ")"));
        elements_.push_back(std::move(element));
    }

    void read_property(const std::vector<std::string_view>& words) {
        const bool is_list = words.size() == 5 && words[1] == "list";
        if (elements_.empty() || (words.size() != 3 && !is_list))
            fail("a property needs an element, a type and a name");
        Property property;
        property.name = words.back();
        if (is_list) property.count_type = &find_type(words[2]);
        property.type = &find_type(words[words.size() - 2]);
        elements_.back().properties.push_back(std::move(property));
    }

    const NumberType& find_type(std::string_view name) const {
        return in_context(cat(path_, ":", line_),
                          [&]() -> const NumberType& { return find_named(number_types, "type", name); });
    }

    void find_vertices() {
        bool has_faces = false;
        for (const Element& element : elements_) {
            has_faces |= element.name == "face" || element.name == "tristrips";
            if (element.name != "vertex") continue;
            vertices_ = static_cast<double>(element.count);
            int coordinates = 0;
            for (const Property& p : element.properties)
                coordinates += p.name == "x" || p.name == "y" || p.name == "z";
            if (coordinates != 3) fail("its vertices have no x, y and z");
        }
        if (vertices_ == 0) fail("has no vertices");
        if (!has_faces) fail("has no faces");
    }

    void check_one(const Element& element, std::uint64_t index) {
        const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
        const auto where = [&] { return cat(element.name, " ", index + 1, " of ", element.count); };
        for (const Property& property : element.properties) {
            if (!property.count_type) {
                const double value = next(*property.type, element, index);
                const bool coordinate = property.name == "x" || property.name == "y" || property.name == "z";
                if (is_vertex && coordinate && !std::isfinite(value))
                    fail(cat(where(), ": ", property.name, " is not a finite number"));
                continue;
            }
            const double size = next(*property.count_type, element, index);
            const bool corners =
                is_face && (property.name == "vertex_indices" || property.name == "vertex_index");
            if (!(size >= 0)) fail(cat(where(), ": a list of ", size));
            if (corners && !(size >= 3 && size <= most_corners))
                fail(cat(where(), ": a face of ", size, " corners (3 to ", most_corners, ")"));
            for (double i = 0; i < size; ++i) {
                const double value = next(*property.type, element, index);
                if (corners && !(value >= 0 && value < vertices_))
                    fail(cat(where(), ": vertex ", static_cast<long long>(value), " (0 to ",
                             static_cast<long long>(vertices_) - 1, ")"));
            }
        }
    }

    double next(const NumberType& type, const Element& element, std::uint64_t index) {
        const auto cut_short = [&] {
            fail(cat("ends inside ", element.name, " ", index + 1, " of ", element.count));
        };
        if (!text_) {
            if (rest_.size() < type.bytes) cut_short();
            const double value = type.read(rest_.data(), order_);
            rest_.remove_prefix(type.bytes);
            return value;
        }
        size_t at = 0;
        for (; at < rest_.size() && std::string_view(" \t\r\n").find(rest_[at]) != std::string_view::npos;
             ++at)
            if (rest_[at] == '\n') ++line_;
        rest_.remove_prefix(at);
        if (rest_.empty()) cut_short();
        const std::string_view word = rest_.substr(0, std::min(rest_.find_first_of(" \t\r\n"), rest_.size()));
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        double value = 0;
        const auto [end, trouble] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (trouble != std::errc{} || end != digits.data() + digits.size())
            fail(cat("\"", word.substr(0, 40), "\" is not a number"));
        rest_.remove_prefix(word.size());
        return value;
    }

    std::string path_;
    std::string_view rest_;  // what is not read yet
    int line_ = 0;           // 0: not in a text
    bool text_ = false;
    std::endian order_ = std::endian::little;
    std::vector<Element> elements_;
    double vertices_ = 0;
};

}  // namespace

void check_ply(const std::string& path, std::string_view bytes) {
    PlyCheck(path, bytes).run();
}

}  // namespace drape
