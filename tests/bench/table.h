// Results in rows, as plain text, Markdown or comma-separated values.
#pragma once

#include <string>
#include <vector>

namespace drape::bench {

struct Table {
    std::vector<std::string> head = {};
    std::vector<std::vector<std::string>> rows = {};

    std::string text() const;  // columns aligned
    std::string markdown() const;
    std::string csv() const;
};

}  // namespace drape::bench
