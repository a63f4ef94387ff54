#include "video/piped_program.h"

#include <vector>

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

std::span<const std::uint8_t> bytes_of_text(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

TEST_CASE("what is written arrives at the program's standard input", "[video]") {
    const TemporaryFolder folder;
    PipedProgram program({"dd", "of=" + folder.file("out"), "status=none"});
    std::string all;
    for (int k = 0; k < 20; ++k) {
        const std::string part(50000, static_cast<char>('a' + k));
        REQUIRE(program.write(bytes_of_text(part)));
        all += part;
    }
    CHECK(program.finish().empty());
    CHECK(bytes_of(folder.file("out")) == all);
    CHECK(program.cpu_seconds() > 0);
}

TEST_CASE("a program that fails is told by its last line, one that is killed by the signal", "[video]") {
    const auto end_of = [](const std::string& script) { return PipedProgram({"sh", "-c", script}).finish(); };
    CHECK(end_of("exit 0").empty());
    CHECK(end_of("echo first >&2; echo; echo no such luck >&2; echo >&2; exit 1") == "sh: no such luck");
    CHECK(end_of("echo '[libx264 @ 0x55d0c8] too odd' >&2; echo 'Conversion failed!' >&2; exit 1") ==
          "sh: too odd");
    CHECK(end_of("exit 7") == "sh ended with exit code 7");
    CHECK(end_of("kill -9 $$") == "sh was ended by a signal: Killed");
}

TEST_CASE("writing to a program that has ended fails without a signal", "[video]") {
    PipedProgram program({"sh", "-c", "echo had enough >&2; exit 3"});
    const std::string much(1 << 20, 'x');
    bool taken = true;
    for (int k = 0; k < 10 && taken; ++k) taken = program.write(bytes_of_text(much));
    CHECK_FALSE(taken);
    CHECK(program.finish() == "sh: had enough");
}

TEST_CASE("a program that is not installed is named", "[video]") {
    try {
        PipedProgram program({"drape-has-no-such-program"});
        FAIL("started");
    } catch (const Error& error) {
        CHECK(error.what() == std::string("drape-has-no-such-program is not installed"));
        CHECK(error.code() == Exit::cannot_write);
    }
}
