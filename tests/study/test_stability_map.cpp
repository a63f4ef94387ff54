// A very small map: the same on any number of threads, counted, and told without markup from names.
#include "study/stability_map.h"

#include <catch2/catch.hpp>

#include "study/stability_csv.h"
#include "study/stability_findings.h"
#include "study/stability_page.h"
#include "study/stability_plot.h"

using namespace drape;

namespace {

StabilityMap tiny_map(int threads) {
    std::vector<StabilityCloth> all = built_in_cloths();
    StabilityOptions options;
    options.stiffness = decades(1, 1e4, 1);
    options.step = decades(1e-4, 1e-1, 1);
    options.methods = methods_named({"verlet", "tr_bdf2"});
    options.trial = {.runs = 2, .steps = 40, .auto_frames = 2};
    options.threads = threads;
    return make_stability_map({all.front(), all.back()}, 1, options);
}

}  // namespace

TEST_CASE("decades are evenly spaced and hold both ends", "[study]") {
    const std::vector<double> values = decades(1e-2, 10, 2);
    REQUIRE(values.size() == 7);
    CHECK(values.front() == Approx(1e-2));
    CHECK(values[2] == Approx(0.1));
    CHECK(values.back() == Approx(10));
}

TEST_CASE("a map does not depend on the number of threads", "[study]") {
    CHECK(stability_csv(tiny_map(1)) == stability_csv(tiny_map(2)));
}

TEST_CASE("a map holds every method on the grid, explicit ones near their limit, and drape's own choice",
          "[study]") {
    const StabilityMap map = tiny_map(2);
    CHECK(map.cells_of(0, "tr_bdf2").size() == 5 * 4);
    CHECK(map.cells_of(0, "verlet").size() > 5 * 4);
    CHECK(map.cells_of(0, auto_name).size() == 5);
    CHECK(map.cells_of(1, "verlet").empty());
    CHECK(map.cells_of(1, auto_name).size() == 5);
    CHECK(count_cells(map, auto_name).failed() == 0);
    const StabilityCount verlet = count_cells(map, "verlet");
    REQUIRE(verlet.up_to);
    CHECK(*verlet.up_to > 0.5);
    CHECK(*verlet.up_to < 1.1);
    CHECK(verlet.failed() > 0);
    CHECK_THAT(summary_of(map, "verlet"), Catch::StartsWith("verlet: stable up to "));
}

TEST_CASE("a map's page and script hold no text that could be taken for markup or commands", "[study]") {
    StabilityMap map = tiny_map(2);
    map.cloths[0].mesh = "a <small> & 'plain' \"scene\"";
    map.cells.front().verdict.state = Stability::refused;
    map.cells.front().verdict.why = "refused: <script>";
    const std::string page =
        stability_page(map, {{}, "no gnuplot <here>"}, {"drape stability 'a<b'", "1", "", "", "cpu", 2});
    CHECK_THAT(page, !Catch::Contains("<script>") && !Catch::Contains("<small>") &&
                         !Catch::Contains("<here>") && Catch::Contains("refused: &lt;script&gt;") &&
                         Catch::Contains("a &lt;small&gt;"));
    CHECK_THAT(stability_script(map), Catch::Contains("''plain''"));
    CHECK_THAT(stability_csv(map), Catch::Contains("\"a <small> & 'plain' \"\"scene\"\"\""));
}
