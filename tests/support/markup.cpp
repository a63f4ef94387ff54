#include "support/markup.h"

#include <regex>
#include <stack>

namespace drape::test {

std::string unbalanced(const std::string& page) {
    static const std::regex tag("<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>");
    std::stack<std::string> open;
    for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
        const std::string name = (*it)[2];
        if (name == "meta" || name == "img" || name == "input" || (*it)[3] == "/") continue;
        if ((*it)[1] != "/") {
            open.push(name);
        } else {
            if (open.empty() || open.top() != name) return name;
            open.pop();
        }
    }
    return open.empty() ? "" : open.top();
}

}  // namespace drape::test
