#include "base/names.h"

#include <algorithm>

namespace drape {

int edit_distance(std::string_view a, std::string_view b) {
    const size_t rows = a.size() + 1, columns = b.size() + 1;
    std::vector<int> d(rows * columns);
    const auto at = [&](size_t i, size_t j) -> int& { return d[i * columns + j]; };
    for (size_t i = 0; i < rows; ++i) at(i, 0) = static_cast<int>(i);
    for (size_t j = 0; j < columns; ++j) at(0, j) = static_cast<int>(j);
    for (size_t i = 1; i < rows; ++i) {
        for (size_t j = 1; j < columns; ++j) {
            const int replace = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return at(rows - 1, columns - 1);
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& known) {
    std::string best;
    int best_distance = static_cast<int>(std::max<size_t>(word.size(), 3)) / 2 + 1;
    for (const std::string& name : known) {
        const int distance = edit_distance(word, name);
        if (distance < best_distance) {
            best = name;
            best_distance = distance;
        }
    }
    return best;
}

std::string unknown_name(std::string_view what, std::string_view word,
                         const std::vector<std::string>& known) {
    std::string text = cat("unknown ", what, " \"", word, "\"");
    if (const std::string near = nearest_name(word, known); !near.empty())
        text += cat("; did you mean \"", near, "\"?");
    return cat(text, " (known: ", joined(known), ")");
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace drape
