// Results do not depend on how wide the machine's vectors are.
#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

namespace {

std::string printed_by(const std::string& program) {
    std::string all;
    std::FILE* pipe = popen(("\"" + program + "\"").c_str(), "r");
    REQUIRE(pipe);
    char piece[4096];
    while (const size_t got = std::fread(piece, 1, sizeof piece, pipe)) all.append(piece, got);
    CHECK(pclose(pipe) == 0);
    return all;
}

}  // namespace

TEST_CASE("every method gives the same bits at any vector width", "[simulate]") {
    const std::string narrow = printed_by(FRAME_BITS_NARROW);
    CHECK_THAT(narrow, Catch::Contains("flag verlet ") && Catch::Contains("neo_hookean xpbd ") &&
                           !Catch::Contains("nan"));
    CHECK(printed_by(FRAME_BITS) == narrow);
#ifdef FRAME_BITS_AVX2
    if (__builtin_cpu_supports("avx2")) CHECK(printed_by(FRAME_BITS_AVX2) == narrow);
#endif
}
