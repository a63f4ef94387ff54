// Bricks of a page.
#pragma once

#include <string>
#include <vector>

namespace drape {

std::string paragraph(const std::string& text);  // escapes
// A table; cells are escaped, those after `words` of a row are set as numbers.
std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                  std::size_t words);

// An SVG file's text as part of a page: without its prolog, and with its ids, which must be unique on a page,
// made so by `prefix`.
std::string inlined_svg(const std::string& svg, const std::string& prefix, const std::string& title);

std::string section(const std::string& title, const std::string& body);  // escapes the title
// The same with its caption; "" where there is no picture.
std::string figure_of(const std::string& svg, const std::string& prefix, const std::string& caption);

// A whole page, styled, that needs no other file. All but the body is escaped.
std::string html_page(const std::string& title, const std::string& subject, const std::string& lead,
                      const std::string& body);

}  // namespace drape
