// Numbers and points as bytes, for checkpoints: native order, read back by the same build only.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/points.h"

namespace drape {

class ByteWriter {
public:
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void put(Number value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void put(std::string_view text) {
        put(static_cast<std::uint64_t>(text.size()));
        bytes_.append(text);
    }
    void put(const Points& points) {
        put(static_cast<std::uint64_t>(points.cols()));
        bytes_.append(reinterpret_cast<const char*>(points.data()),
                      static_cast<size_t>(points.size()) * sizeof(double));
    }
    std::string bytes() && { return std::move(bytes_); }

private:
    std::string bytes_;
};

// Reads what ByteWriter put, in the same order. After the first thing that is not there, ok() is false and
// everything read is zero or empty.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    template <class Number>
    requires std::is_arithmetic_v<Number> Number take() {
        Number value{};
        if (rest_.size() < sizeof value) return fail(value);
        if (std::is_same_v<Number, bool> && rest_.front() != 0 && rest_.front() != 1) return fail(value);
        std::memcpy(&value, rest_.data(), sizeof value);
        rest_.remove_prefix(sizeof value);
        return value;
    }
    std::string take_text() {
        const auto size = take<std::uint64_t>();
        if (rest_.size() < size) return fail(std::string());
        std::string text(rest_.substr(0, size));
        rest_.remove_prefix(size);
        return text;
    }
    Points take_points() {
        const auto columns = take<std::uint64_t>();
        if (columns > rest_.size() / (3 * sizeof(double))) return fail(Points());
        Points points(3, static_cast<Eigen::Index>(columns));
        if (columns > 0) std::memcpy(points.data(), rest_.data(), columns * 3 * sizeof(double));
        rest_.remove_prefix(columns * 3 * sizeof(double));
        return points;
    }
    bool ok() const { return ok_; }
    bool at_end() const { return ok_ && rest_.empty(); }

private:
    template <class Value>
    Value fail(Value nothing) {
        ok_ = false;
        rest_ = {};
        return nothing;
    }
    std::string_view rest_;
    bool ok_ = true;
};

}  // namespace drape
