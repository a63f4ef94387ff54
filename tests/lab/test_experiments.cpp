// What holds for every experiment.
#include "lab/experiment.h"

#include <set>

#include <catch2/catch.hpp>

#include "base/error.h"

using namespace drape;

TEST_CASE("experiments are found by name, once each, in the story's order", "[lab]") {
    CHECK(experiments_named({}).size() == experiments().size());
    const std::string first(experiments().front().name), last(experiments().back().name);
    const auto wanted = experiments_named(std::vector<std::string>{last, first, last});
    REQUIRE(wanted.size() == (first == last ? 1 : 2));
    CHECK(wanted.front() == &experiments().front());
    CHECK_THROWS_AS(experiments_named(std::vector<std::string>{"anisotrpy"}), Error);
}

TEST_CASE("every quick experiment has a claim, a story, and figures with their csv", "[lab]") {
    std::set<std::string> files;
    for (const Experiment& experiment : experiments()) {
        if (!experiment.quick) continue;
        const std::string name(experiment.name);
        const LabResult result = experiment.run();
        CAPTURE(name, result.claim);
        CHECK_FALSE(result.claim.empty());
        CHECK(result.claim.find('\n') == std::string::npos);
        CHECK_FALSE(result.story.empty());
        REQUIRE_FALSE(result.figures.empty());
        CHECK(result.figures.front().file == name);
        REQUIRE_FALSE(result.csv.empty());
        CHECK(result.csv.front().file == name);
        for (const LabFigure& figure : result.figures) CHECK(files.insert(figure.file).second);
        for (const LabCsv& csv : result.csv) {
            CHECK(csv.text.back() == '\n');
            CHECK_THAT(csv.text, !Catch::Contains("nan") && !Catch::Contains("inf"));
        }
        for (const LabTable& table : result.tables)
            for (const auto& row : table.rows) CHECK(row.size() == table.head.size());
    }
}
