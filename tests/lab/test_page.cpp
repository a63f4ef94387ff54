#include "lab/page.h"

#include <catch2/catch.hpp>

using namespace drape;

namespace {

LabChapter chapter(const Experiment& experiment, const std::string& claim) {
    LabResult result;
    result.claim = claim;
    result.story = {"why <so>"};
    result.figures = {{"first", "what it shows", 10, 10, "", ""}};
    result.tables = {{{"law", "figure"}, {{"a & b", "1"}}, 1}};
    result.csv = {{"first", "x\n"}};
    return {&experiment, result, {"<?xml?><svg width=\"1\"><g id=\"g\"/></svg>"}};
}

}  // namespace

TEST_CASE("the page tells claims first, then each experiment in its order, escaped", "[lab]") {
    const Experiment one{"one", "the first", nullptr}, two{"two", "the second", nullptr};
    const std::string page = lab_page({chapter(one, "less < more"), chapter(two, "so it is")}, "",
                                      {"drape lab", "1", "5", "", ""});
    CHECK_THAT(page, Catch::Contains("<li>one: less &lt; more</li>") && Catch::Contains("why &lt;so&gt;") &&
                         Catch::Contains("a &amp; b") && Catch::Contains("first.csv"));
    CHECK(page.find("one: the first") < page.find("two: the second"));
    // ids stay apart
    CHECK_THAT(page, Catch::Contains("one0_g") && Catch::Contains("two0_g"));
    CHECK_THAT(page, !Catch::Contains("No plots"));
}

TEST_CASE("a page without plots says why", "[lab]") {
    const Experiment one{"one", "the first", nullptr};
    LabChapter without = chapter(one, "so");
    without.svg.clear();
    const std::string page = lab_page({without}, "gnuplot is not installed", {"drape lab", "1", "", "", ""});
    CHECK_THAT(page, Catch::Contains("No plots: gnuplot is not installed.") && !Catch::Contains("<svg"));
}
