// The same picture from both back-ends and from any number of threads. Drivers read their settings once per
// process, so each variant is drawn by a process of its own: this program, asked for its hidden test.
#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "base/error.h"
#include "base/hash.h"
#include "support/small_picture.h"

using namespace drape;

namespace {

std::string hash_of(const Image& image) {
    return hash_text(hash_bytes(image.rgb.data(), image.rgb.size()));
}

std::string hash_from_process(const std::string& environment) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = environment + " '" + program + "' '[.draw_one]' -r compact";
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string output;
    std::array<char, 256> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), pipe)) output += line.data();
    REQUIRE(pclose(pipe) == 0);
    const size_t at = output.find("picture ");
    REQUIRE(at != std::string::npos);
    return output.substr(at + 8, 16);
}

}  // namespace

TEST_CASE("prints the hash of one picture", "[.draw_one]") {
    const std::string hash = hash_of(SmallPicture().draw());
    REQUIRE(hash.size() == 16);  // what hash_from_process cuts out
    std::cout << "picture " << hash << "\n";
}

TEST_CASE("any number of threads draws the same pixels", "[render]") {
    const std::string here = hash_of(SmallPicture().draw());
    for (const char* threads : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=1", "LP_NUM_THREADS=3"}) {
        CAPTURE(threads);
        CHECK(hash_from_process(threads) == here);
    }
}

TEST_CASE("EGL draws the same pixels as OSMesa", "[render]") {
    const SmallPicture picture;
    const Image osmesa = picture.draw(Backend::osmesa);
    try {
        const Image egl = picture.draw(Backend::egl_surfaceless);
        CHECK(pixels_apart(osmesa, egl) == 0);
    } catch (const Error& error) {
        WARN("not compared: " << error.what());
        CHECK(std::string(error.what()).find("EGL") != std::string::npos);
    }
}
