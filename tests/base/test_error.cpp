#include "base/error.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("an error that leaves a context carries it in front and keeps its exit code", "[base]") {
    try {
        in_context("flag.toml:3", [] { throw Error("radius must be positive, got -1", Exit::cannot_write); });
        FAIL("the error was lost");
    } catch (const Error& error) {
        CHECK(std::string(error.what()) == "flag.toml:3: radius must be positive, got -1");
        CHECK(error.code() == Exit::cannot_write);
    }
    CHECK(in_context("nothing wrong", [] { return 7; }) == 7);
}
