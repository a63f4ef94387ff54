#include "study/html.h"

#include <regex>

#include "base/markup.h"

namespace drape {

namespace {

constexpr std::size_t long_text = 60;  // from here on it is broken into lines

constexpr const char* style =
    "body{font:16px/1.55 system-ui,-apple-system,'Segoe UI',sans-serif;color:#222;background:#fff;"
    "max-width:70rem;margin:2.5rem auto;padding:0 1.25rem}"
    "h1{font-size:1.8rem;line-height:1.2;margin:0 0 .3rem}h2{font-size:1.2rem;margin:2.4rem 0 .5rem}"
    "p,li{max-width:46rem}.answer li{max-width:none}.lead{color:#555;margin:0 0 1.5rem}"
    "ul.answer{list-style:none;padding:.9rem 1.2rem;margin:0;background:#f5f7f9;border-left:4px solid "
    "#0072b2}"
    "figure{margin:1.2rem 0}figcaption{color:#555;font-size:.9rem;max-width:46rem}"
    "svg{max-width:100%;height:auto}.wide{overflow-x:auto}"
    "table{border-collapse:collapse;font-size:.86rem;font-variant-numeric:tabular-nums;white-space:nowrap}"
    "th,td{padding:.22rem .7rem;border-bottom:1px solid #e3e3e3;text-align:left}"
    "th{border-bottom:2px solid "
    "#999;font-weight:600}.n{text-align:right}.w{white-space:normal;min-width:24rem}"
    "tbody tr:hover{background:#f7f7f7}code{background:#f3f3f3;padding:.1rem .3rem}";

std::string cell(const std::string& text, bool words) {
    const char* start = !words ? "<td class=\"n\">" : text.size() > long_text ? "<td class=\"w\">" : "<td>";
    return start + escaped(text) + "</td>";
}

}  // namespace

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

std::string section(const std::string& title, const std::string& body) {
    return "<section>\n<h2>" + escaped(title) + "</h2>\n" + body + "</section>\n";
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

std::string figure_of(const std::string& svg, const std::string& prefix, const std::string& caption) {
    if (svg.empty()) return "";
    return "<figure>" + inlined_svg(svg, prefix, caption) + "<figcaption>" + escaped(caption) +
           "</figcaption></figure>\n";
}

std::string html_page(const std::string& title, const std::string& subject, const std::string& lead,
                      const std::string& body) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">\n<title>" +
           escaped(title + ": " + subject) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
           escaped(title) + "</h1>\n<p class=\"lead\">" + escaped(subject + "; " + lead) + "</p>\n" + body +
           "</body>\n</html>\n";
}

}  // namespace drape
