// The page and the plots' script hold no text that could be taken for markup or commands.
#include <catch2/catch.hpp>

#include "study/html.h"
#include "study/plot_style.h"
#include "study/small_study.h"
#include "study/study_page.h"
#include "study/study_plot.h"
#include "support/markup.h"

using namespace drape;
using namespace drape::test;

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
