#include "gallery/catalogue.h"

#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

std::string refusal(const std::string& text) {
    const TemporaryFolder folder;
    const std::string path = folder.file("gallery.toml", text);
    return error_of([&] { read_catalogue(path); });
}

}  // namespace

TEST_CASE("a catalogue is read with what all panes of a piece have in common", "[gallery]") {
    const TemporaryFolder folder;
    const Catalogue catalogue = read_catalogue(folder.file(
        "gallery.toml",
        "schema = 1\n[[piece]]\nscene = \"flag\"\n[[piece]]\nscene = \"own/small.toml\"\nname = "
        "\"two\"\ntitle "
        "= \"Two\"\nsize = [320, 180]\nposter = 7\nset = [\"a=1\"]\n[[piece.pane]]\nlabel = \"x\"\n"
        "[[piece.pane]]\nlabel = \"y\"\nset = [\"b=2\"]\n"));
    REQUIRE(catalogue.pieces.size() == 2);
    CHECK(catalogue.pieces[0].name == "flag");
    CHECK(catalogue.pieces[0].scene == "flag");
    REQUIRE(catalogue.pieces[0].panes.size() == 1);
    const Piece& two = catalogue.pieces[1];
    CHECK(two.name == "two");
    CHECK(two.scene == folder.file("own/small.toml"));
    CHECK(two.size == std::array{320, 180});
    CHECK(two.poster == 7);
    REQUIRE(two.panes.size() == 2);
    CHECK(two.panes[0].set == std::vector<std::string>{"a=1"});
    CHECK(two.panes[1].set == std::vector<std::string>{"a=1", "b=2"});
    CHECK(two.panes[1].label == "y");
}

TEST_CASE("what is wrong in a catalogue is told at its place", "[gallery]") {
    CHECK(refusal("schema = 1\n[[piece]]\nscen = \"flag\"\n").find(":3:1: unknown piece key \"scen\"; did") !=
          std::string::npos);
    CHECK(refusal("schema = 1\n[[piece]]\nscene = \"flag\"\n[[piece]]\nscene = \"flag\"\n")
              .find("\"flag\" is the name of another piece too") != std::string::npos);
    CHECK(refusal("schema = 1\n[[piece]]\nscene = \"flag\"\nname = \"../x\"\n").find("name: \"../x\"") !=
          std::string::npos);
    CHECK(refusal("schema = 1\npiece = []\n").find("at least one") != std::string::npos);
}

TEST_CASE("drape's own gallery shows every demo scene and four comparisons", "[gallery]") {
    const Catalogue catalogue = read_catalogue(DRAPE_SOURCE_DIR "/assets/gallery/gallery.toml");
    std::set<std::string> shown;
    int comparisons = 0;
    for (const Piece& piece : catalogue.pieces) {
        CHECK_FALSE(piece.says.empty());
        shown.insert(piece.scene);
        comparisons += piece.panes.size() > 1;
    }
    for (const auto& entry : std::filesystem::directory_iterator(DRAPE_SOURCE_DIR "/assets/scenes"))
        if (entry.path().extension() == ".toml") CHECK(shown.count(entry.path().stem().string()) == 1);
    CHECK(comparisons >= 4);
}
