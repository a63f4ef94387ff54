#include "compare/charts.h"

#include <catch2/catch.hpp>

using namespace drape;
using Catch::Contains;

TEST_CASE("the first bad frame is marked and bars lead to their frames and names are escaped", "[compare]") {
    const std::string svg = timeline({{"a", 0, "identical"},
                                      {"<b>", 0.5, "0.5 levels", true, "#f1"},
                                      {"c", 5, "5 levels", true},
                                      {"d", {}, "missing", true}},
                                     0.002, "what");
    CHECK_THAT(svg, Contains("first bad: &lt;b&gt;</text>") && !Contains("<b>"));
    CHECK_THAT(svg, Contains("<a href=\"#f1\"><g><rect") && Contains("class=\"limit\"") &&
                        Contains("class=\"lacking\""));
    CHECK_THAT(svg, Contains("<title>c: 5 levels</title>"));
    CHECK_THAT(timeline({{"a", 1, "1"}}, {}, "what"),
               !Contains("class=\"first\"") && !Contains("class=\"limit\""));
    CHECK(timeline({}, {}, "what").empty());
}

TEST_CASE("bars of a timeline are higher where the value is", "[compare]") {
    const auto height_of = [](double value) {
        const std::string svg = timeline({{"a", value, ""}, {"b", 1, ""}, {"c", 1e-4, ""}}, {}, "what");
        const size_t at = svg.find(" height=\"") + 9;
        return std::stod(svg.substr(at));
    };
    CHECK(height_of(0) < height_of(1e-3));
    CHECK(height_of(1e-3) < height_of(1e-2));
    CHECK(height_of(1e-2) < height_of(0.9));
}

TEST_CASE("a histogram counts every pixel in the class of its levels", "[compare]") {
    std::array<std::int64_t, 256> pixels{};
    pixels[0] = 700;
    pixels[3] = 20;
    pixels[4] = 3;
    pixels[255] = 9;
    const std::string svg = histogram(pixels);
    for (const char* label : {">700<", ">23<", ">9<", ">0<", ">3-4<", ">129-255<"})
        CHECK_THAT(svg, Contains(label));
    CHECK_THAT(svg, !Contains("nan") && !Contains("inf"));
}
