#include "base/shell_word.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a word that a shell would take apart is quoted", "[base]") {
    CHECK(shell_word("renders/flag_2.png") == "renders/flag_2.png");
    CHECK(shell_word("") == "''");
    CHECK(shell_word("two words") == "'two words'");
    CHECK(shell_word("it's; $(x)") == "'it'\\''s; $(x)'");
}
