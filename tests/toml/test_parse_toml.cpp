// Hostile files: whatever the bytes, the reader answers with one line.

#include <catch2/catch.hpp>

#include "support/scene_file.h"
#include "toml/value.h"

using namespace drape;
using namespace drape::test;

namespace {

std::string repeated(const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += piece;
    return text;
}

// the line that refuses this text: there is one, it is one, and it is short enough to read
std::string refusal(const std::string& text) {
    const std::string message = error_of(text);
    CHECK(message.starts_with("scene.toml:"));
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.size() < 400);
    return message;
}

}  // namespace

TEST_CASE("values keep their kinds, their order and their places", "[scene]") {
    const Value root = parse_toml("b = 1\na = [2.5, \"x\"]\n[t]\n  on = true\n  day = 1979-05-27\n", "f");
    REQUIRE(root.find("b"));
    CHECK(root.find("b")->kind == Value::Kind::integer);
    CHECK(root.find("b")->real == 1);
    CHECK(root.find("b")->place.text == "f:1:5");
    CHECK(root.find("b")->key_place.text == "f:1:1");
    REQUIRE(root.find("a")->items.size() == 2);
    CHECK(root.find("a")->items[0].real == 2.5);
    CHECK(root.find("a")->items[1].text == "x");
    CHECK(root.find("a")->items[1].place.text == "f:2:11");
    CHECK(root.find("t")->find("on")->boolean);
    CHECK(root.find("t")->find("on")->key_place.text == "f:4:3");
    CHECK(root.find("t")->find("day")->kind == Value::Kind::date);
    CHECK(root.find("c") == nullptr);
}

TEST_CASE("a file cut anywhere is read or refused, never more", "[scene]") {
    const std::string whole = with_cloth(
        "fabric = { preset = \"silk\", thickness = \"1 mm\" }\n[[obstacle]]\nshape = \"sphere\"\n"
        "motion = [{ t = 0, translate = [0, 1e-3, 0] }]\n");
    for (size_t length = 0; length < whole.size(); ++length) {
        const std::string message = error_of(whole.substr(0, length));
        CAPTURE(length, message);
        CHECK(message.find('\n') == std::string::npos);
        CHECK((message.empty() || message.starts_with("scene.toml:")));
    }
}

TEST_CASE("binary, deep, huge and contradictory files get one line", "[scene]") {
    refusal(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
    refusal(std::string(1000, '\0'));
    refusal("schema = 1\nname = \"\xff\xfe\"\n");
    refusal("schema = " + repeated("[", 100'000));
    refusal("schema = " + repeated("{ a = ", 100'000));
    refusal("schema = 1\n" + repeated("a.", 400'000) + "a = 1\n");
    refusal("schema = 1\n" + repeated("\"=\" . ", 100'000) + "a = 1\n");
    refusal("schema = 1\n[" + repeated("a.", 400'000) + "a]\n");
    refusal("schema = 1\nschema = 1\n");
    refusal("schema = 1\nschema = '''1'''\n");
    refusal(with_cloth("[scene]\ngravity = [" + repeated("0,", 400'000) + "0]\n"));
    refusal(with_cloth("[scene]\n" + std::string(500'000, 'k') + " = 1\n"));
    refusal(with_cloth("fabric = \"" + std::string(500'000, 'k') + "\"\n"));
    refusal(with_cloth("fabric = \"a\\nb\\u001b[2J\"\n"));
    refusal("schema = 1 1\n");
    CHECK(error_of(std::string(2 << 20, ' ')) == "scene.toml: too large for a scene file (at most 1 MiB)");
}

TEST_CASE("dots in texts, comments and numbers are not mistaken for deep keys", "[scene]") {
    CHECK(error_of(with_cloth("# " + repeated("a.", 100) + "\nmesh = \"" + repeated("../", 100) +
                              "a\\\".obj\"\n")) ==
          "scene.toml:2:1: a cloth needs exactly one of mesh, pattern");
    CHECK(error_of(with_cloth("[scene]\ngravity = [0.0, 0.0, 0.0] # 'it's " + repeated("x.", 50) + "\n"))
              .empty());
}
