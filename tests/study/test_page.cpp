// The page and the plots' script hold no text that could be taken for markup or commands.
#include <catch2/catch.hpp>
#include <regex>
#include <stack>

#include "study/html.h"
#include "study/plot_style.h"
#include "study/small_study.h"
#include "study/study_page.h"
#include "study/study_plot.h"

using namespace drape;
using namespace drape::test;

namespace {

// The first tag that is opened and not closed in turn; "" if all are.
std::string unbalanced(const std::string& page) {
    static const std::regex tag("<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>");
    std::stack<std::string> open;
    for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
        const std::string name = (*it)[2];
        if (name == "meta" || (*it)[3] == "/") continue;
        if ((*it)[1] != "/") {
            open.push(name);
        } else {
            if (open.empty() || open.top() != name) return name;
            open.pop();
        }
    }
    return open.empty() ? "" : open.top();
}

}  // namespace

TEST_CASE("the page escapes what scenes and errors say, and is well formed", "[study]") {
    Study study = small_study();
    study.refused.push_back({&method_named("srkn4"), "refused: <script>alert('x')</script> & more"});
    study.rungs.front().failed = "went <b>wrong</b>";
    const std::string page =
        study_page(study, {"", "", "no gnuplot <here>"}, {"drape study 'a<b'", "1", "", "6", "cpu", 2});
    CHECK_THAT(page, !Catch::Contains("<script>") && !Catch::Contains("<b>") && !Catch::Contains("<small>") &&
                         !Catch::Contains("<here>"));
    CHECK_THAT(page, Catch::Contains("refused: &lt;script&gt;") && Catch::Contains("went &lt;b&gt;wrong"));
    CHECK_THAT(page, Catch::Contains("What failed and why") && Catch::Contains("No plots: no gnuplot"));
    CHECK(unbalanced(page) == "");
}

TEST_CASE("an inlined plot loses its prolog and has ids of its own", "[study]") {
    const std::string svg =
        inlined_svg("<?xml version=\"1.0\"?>\n<svg width=\"3\"><g id=\"p\"/><use xlink:href='#p'/></svg>",
                    "a_", "a \"title\"");
    CHECK(svg ==
          "<svg role=\"img\" aria-label=\"a &quot;title&quot;\" width=\"3\"><g id=\"a_p\"/><use "
          "xlink:href='#a_p'/></svg>");
}

TEST_CASE("text in the plots' script cannot end its quotes", "[study]") {
    CHECK(plot_quoted("it's\n'; system('x") == "'it''s ''; system(''x'");
    CHECK_THAT(plot_script(small_study()), Catch::Contains("''plain''"));
}
