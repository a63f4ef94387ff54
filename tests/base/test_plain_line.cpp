#include "base/plain_line.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("text from a file is one line that steers no terminal", "[base]") {
    CHECK(plain_line("") == "");
    CHECK(plain_line("Bézier 2 µm") == "Bézier 2 µm");
    CHECK(plain_line("two\nlines\r\t\x1b[31m\x7f") == "two?lines???[31m?");
    CHECK(plain_line(std::string_view("a\0b", 3)) == "a?b");
}
