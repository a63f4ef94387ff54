#include "base/names.h"

#include <array>
#include <catch2/catch.hpp>

using namespace drape;

namespace {

struct Row {
    std::string_view name;
    int value;
};
constexpr std::array table{Row{"plane", 1}, Row{"sphere", 2}, Row{"capsule", 3}};

}  // namespace

TEST_CASE("the edit distance counts inserts, deletes, replacements and swaps of neighbours", "[base]") {
    CHECK(edit_distance("sphere", "sphere") == 0);
    CHECK(edit_distance("spere", "sphere") == 1);
    CHECK(edit_distance("spphere", "sphere") == 1);
    CHECK(edit_distance("sphare", "sphere") == 1);
    CHECK(edit_distance("shpere", "sphere") == 1);
    CHECK(edit_distance("", "abc") == 3);
    CHECK(edit_distance("kitten", "sitting") == edit_distance("sitting", "kitten"));
}

TEST_CASE("the nearest name is the one a slip of the fingers away, and none if nothing is near", "[base]") {
    const std::vector<std::string> known{"density", "thickness", "stretch"};
    CHECK(nearest_name("densty", known) == "density");
    CHECK(nearest_name("tickness", known) == "thickness");
    CHECK(nearest_name("colour", known).empty());
    CHECK(nearest_name("x", {}).empty());
}

TEST_CASE("looking up an unknown name teaches the known ones", "[base]") {
    CHECK(find_named(table, "obstacle", "sphere").value == 2);
    try {
        find_named(table, "obstacle", "spere");
        FAIL("an unknown name was found");
    } catch (const Error& error) {
        CHECK(error.code() == Exit::bad_input);
        CHECK(std::string(error.what()) ==
              "unknown obstacle \"spere\"; did you mean \"sphere\"? (known: plane, sphere, capsule)");
    }
}
