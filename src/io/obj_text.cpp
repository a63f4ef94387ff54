#include "io/obj_text.h"

#include <charconv>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "io/assimp_import.h"

namespace drape {

namespace {

constexpr int most_corners =
    4096;  // cutting a polygon into triangles takes time as the square of its corners

struct Corner {
    long long vertex = 0, uv = 0;  // counted from 1; uv 0: none
};

struct Face {
    int line, first_corner, corners;
};

class ObjReader {
public:
    explicit ObjReader(const std::string& path) : path_(path) {}

    void read(std::string_view text) {
        for (int number = 1; !text.empty();) {
            const int first_line = number;
            const std::string_view line = next_line(text, number);
            line_ = first_line;
            read_line(line);
        }
    }

    ObjText finish() const {
        ObjText obj;
        obj.points_lines = points_lines_;
        obj.vertices = Eigen::Map<const Points>(xyz_.data(), 3, static_cast<Eigen::Index>(xyz_.size() / 3));
        if (xyz_.empty()) throw Error(cat(path_, ": has no vertices (lines that begin with \"v\")"));
        if (faces_.empty()) throw Error(cat(path_, ": has no faces (lines that begin with \"f\")"));
        check_indices();
        obj.plain = plain_text();
        return obj;
    }

private:
    [[noreturn]] void fail(int line, const std::string& what) const {
        throw Error(cat(path_, ":", line, ": ", what));
    }

    // Cuts the first line off `text`, joined with the next ones while it ends in a backslash.
    std::string_view next_line(std::string_view& text, int& number) {
        joined_.clear();
        for (;;) {
            const size_t end = std::min(text.find('\n'), text.size());
            std::string_view line = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            ++number;
            if (line.ends_with('\r')) line.remove_suffix(1);
            const bool goes_on = line.ends_with('\\') && !text.empty();
            if (!goes_on && joined_.empty()) return line;
            joined_.append(line.substr(0, line.size() - (goes_on ? 1 : 0)));
            joined_ += ' ';
            if (!goes_on) return joined_;
        }
    }

    void read_line(std::string_view line) {
        words_.clear();
        constexpr std::string_view blank = " \t\v\f\r";
        for (size_t at = line.find_first_not_of(blank); at < line.size() && line[at] != '#';) {
            const size_t end = std::min(line.find_first_of(blank, at), line.size());
            words_.push_back(line.substr(at, end - at));
            at = std::min(line.find_first_not_of(blank, end), line.size());
        }
        if (words_.empty()) return;
        const std::string_view keyword = words_.front();
        if (keyword == "v") {
            if (words_.size() < 4)
                fail(line_, cat("a vertex needs three coordinates, got ", words_.size() - 1));
            for (size_t i = 1; i <= 3; ++i) xyz_.push_back(coordinate(words_[i]));
        } else if (keyword == "vt") {
            if (words_.size() < 2) fail(line_, "a texture coordinate needs a number");
            uv_.push_back(coordinate(words_[1]));
            uv_.push_back(words_.size() > 2 ? coordinate(words_[2]) : 0);
        } else if (keyword == "f") {
            read_face();
        } else if (keyword == "l" || keyword == "p") {
            ++points_lines_;
        }
    }

    double coordinate(std::string_view word) const {
        const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
        double value = 0;
        const auto [end, trouble] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (trouble == std::errc::result_out_of_range && end == digits.data() + digits.size())
            fail(line_, cat(word, " is beyond what a number can hold"));
        if (trouble != std::errc{} || end != digits.data() + digits.size())
            fail(line_, cat("\"", word.substr(0, 40), "\" is not a number"));
        if (!std::isfinite(value)) fail(line_, cat(word, " is not a finite number"));
        return value;
    }

    void read_face() {
        const int corners = static_cast<int>(words_.size()) - 1;
        if (corners < 3 || corners > most_corners)
            fail(line_, cat("a face of ", corners, " corners (3 to ", most_corners, ")"));
        faces_.push_back({line_, static_cast<int>(corners_.size()), corners});
        for (int i = 1; i <= corners; ++i) {
            const std::string_view word = words_[static_cast<size_t>(i)];
            const size_t slash = std::min(word.find('/'), word.size());
            std::string_view uv = word.substr(std::min(slash + 1, word.size()));
            uv = uv.substr(0, uv.find('/'));
            Corner corner;
            corner.vertex = index(word.substr(0, slash), xyz_.size() / 3);
            if (!uv.empty()) corner.uv = index(uv, uv_.size() / 2);
            corners_.push_back(corner);
        }
    }

    // An index as counted from 1; a negative one counts back from the `known` last.
    long long index(std::string_view word, size_t known) const {
        long long value = 0;
        const auto [end, trouble] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (trouble != std::errc{} || end != word.data() + word.size())
            fail(line_, cat("\"", word.substr(0, 40), "\" is not a vertex number"));
        const long long counted = value < 0 ? value + static_cast<long long>(known) + 1 : value;
        if (counted < 1)
            fail(line_, cat("index ", value, " with ", known, " defined so far (counted from 1)"));
        return counted;
    }

    // A face may name vertices that follow it, so this waits for the end.
    void check_indices() const {
        const auto vertices = static_cast<long long>(xyz_.size() / 3),
                   uvs = static_cast<long long>(uv_.size() / 2);
        for (const Face& face : faces_) {
            for (int i = 0; i < face.corners; ++i) {
                const Corner& corner =
                    corners_[static_cast<size_t>(face.first_corner) + static_cast<size_t>(i)];
                if (corner.vertex > vertices)
                    fail(face.line,
                         cat("vertex ", corner.vertex, " of ", vertices, " (1 to ", vertices, ")"));
                if (corner.uv > uvs)
                    fail(face.line, cat("texture coordinate ", corner.uv, " of ", uvs, " (1 to ", uvs, ")"));
            }
        }
    }

    std::string plain_text() const {
        std::string plain;
        plain.reserve(12 * xyz_.size() + 12 * corners_.size());
        const auto add = [&](auto number) {
            char digits[32];
            plain += ' ';
            plain.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
        };
        for (size_t i = 0; i < xyz_.size(); i += 3) {
            plain += 'v';
            for (size_t c = 0; c < 3; ++c) add(static_cast<float>(xyz_[i + c]));
            add(static_cast<int>(i / 3) % mark_base);
            add(static_cast<int>(i / 3) / mark_base);
            plain += " 0\n";
        }
        for (size_t i = 0; i < uv_.size(); i += 2) {
            plain += "vt";
            for (size_t c = 0; c < 2; ++c) add(static_cast<float>(uv_[i + c]));
            plain += '\n';
        }
        for (const Face& face : faces_) {
            plain += 'f';
            for (int i = 0; i < face.corners; ++i) {
                const Corner& corner =
                    corners_[static_cast<size_t>(face.first_corner) + static_cast<size_t>(i)];
                add(corner.vertex);
                if (corner.uv == 0) continue;
                plain += '/';
                plain += std::to_string(corner.uv);
            }
            plain += '\n';
        }
        return plain;
    }

    std::string path_;
    int line_ = 0, points_lines_ = 0;
    std::vector<double> xyz_, uv_;
    std::vector<Corner> corners_;
    std::vector<Face> faces_;
    std::vector<std::string_view> words_;  // of the line at hand
    std::string joined_;
};

}  // namespace

ObjText read_obj(const std::string& path, std::string_view text) {
    ObjReader reader(path);
    reader.read(text);
    return reader.finish();
}

}  // namespace drape
