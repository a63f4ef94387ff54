#include "bench/table.h"

#include <algorithm>

namespace drape::bench {

namespace {

using Row = std::vector<std::string>;

std::string padded(const Row& row, const std::vector<size_t>& widths) {
    std::string line;
    for (size_t c = 0; c < row.size(); ++c)
        line += row[c] + (c + 1 < row.size() ? std::string(widths[c] - row[c].size() + 2, ' ') : "");
    return line + "\n";
}

std::string framed(const Row& row) {
    std::string line = "|";
    for (const std::string& cell : row) line += " " + cell + " |";
    return line + "\n";
}

std::string comma_separated(const Row& row) {
    std::string line;
    for (size_t c = 0; c < row.size(); ++c) line += (c > 0 ? ",\"" : "\"") + row[c] + "\"";
    return line + "\n";
}

}  // namespace

std::string Table::text() const {
    std::vector<size_t> widths(head.size(), 0);
    const auto widen = [&](const Row& row) {
        for (size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    };
    widen(head);
    for (const Row& row : rows) widen(row);
    std::string text = padded(head, widths);
    for (const Row& row : rows) text += padded(row, widths);
    return text;
}

std::string Table::markdown() const {
    std::string text = framed(head) + framed(Row(head.size(), "---"));
    for (const Row& row : rows) text += framed(row);
    return text;
}

std::string Table::csv() const {
    std::string text = comma_separated(head);
    for (const Row& row : rows) text += comma_separated(row);
    return text;
}

}  // namespace drape::bench
