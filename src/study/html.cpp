#include "study/html.h"

#include <regex>

namespace drape {

namespace {

constexpr std::size_t long_text = 60;  // from here on it is broken into lines

std::string cell(const std::string& text, bool words) {
    const char* start = !words ? "<td class=\"n\">" : text.size() > long_text ? "<td class=\"w\">" : "<td>";
    return start + escaped(text) + "</td>";
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string paragraph(const std::string& text) {
    return "<p>" + escaped(text) + "</p>\n";
}

std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                  std::size_t words) {
    std::string out = "<div class=\"wide\"><table>\n<thead><tr>";
    for (size_t i = 0; i < head.size(); ++i)
        out += (i < words ? "<th>" : "<th class=\"n\">") + escaped(head[i]) + "</th>";
    out += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        out += "<tr>";
        for (size_t i = 0; i < row.size(); ++i) out += cell(row[i], i < words);
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

std::string inlined_svg(const std::string& svg, const std::string& prefix, const std::string& title) {
    const size_t start = svg.find("<svg");
    if (start == std::string::npos) return "";
    std::string body = svg.substr(start);
    body = std::regex_replace(body, std::regex("\\bid=(['\"])"), "id=$1" + prefix);
    body = std::regex_replace(body, std::regex("href=(['\"])#"), "href=$1#" + prefix);
    body = std::regex_replace(body, std::regex("url\\(#"), "url(#" + prefix);
    return "<svg role=\"img\" aria-label=\"" + escaped(title) + "\"" + body.substr(4);
}

}  // namespace drape
