#include "gallery/page.h"

#include <catch2/catch.hpp>

#include "gallery/cost.h"
#include "support/markup.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Contains;

TEST_CASE("a gallery's page is well formed and needs no network and escapes every name", "[gallery]") {
    ShownPiece made;
    made.name = made.title = "<b>one & two";
    made.has_panes = true;
    made.loop = "a\"b.webp";
    made.poster = "a\"b.png";
    made.width = 640;
    made.height = 360;
    made.commands = {"drape render x --set 'a=<1>'"};
    Cost cost;
    cost.method = "verlet";
    cost.vertices = 81;
    cost.frames = 5;
    cost.error = 3e-3;
    cost.cpu = 1.25;
    made.runs = {{"<left>", cost}, {"right", cost}};
    ShownPiece failed;
    failed.name = failed.title = "broken";
    failed.trouble = "scene.toml:3: <bad>";
    const std::string page = gallery_page({"t & t", "drape 1 <2>", "a & b", {made, failed}});
    CHECK_THAT(page, !Contains("<b>") && !Contains("<1>") && !Contains("<left>") && !Contains("<bad>"));
    CHECK_THAT(page, !Contains("http://") && !Contains("https://") && !Contains("src=\"/"));
    CHECK_THAT(page, Contains("src=\"a&quot;b.png\"") && Contains("data-loop=\"a&quot;b.webp\""));
    CHECK_THAT(page, Contains("2 runs of 81 vertices, 5 frames, 2.5 CPU s"));
    CHECK_THAT(page, Contains("Not made: scene.toml:3: &lt;bad&gt;"));
    CHECK(unbalanced(page.substr(0, page.find("<script>\n"))) == "body");
}

TEST_CASE("what is no report of a run has no cost", "[gallery]") {
    const TemporaryFolder folder;
    CHECK(error_of([&] {
              read_cost(folder.file("report.json", "{\"scene\": 3}"));
          }).find("report.json: is no report.json of a run") != std::string::npos);
}
