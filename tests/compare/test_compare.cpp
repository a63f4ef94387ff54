#include "compare/compare.h"

#include <array>
#include <cstring>
#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "compare/comparison_json.h"
#include "io/png.h"
#include "io/write_file.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

namespace {

Image grey(int width = 400, int height = 250) {
    Image image(width, height);
    for (auto& level : image.rgb) level = 100;
    return image;
}

void write_picture(const std::string& path, const Image& image) {
    write_file(path, encode_png(image));
}

// One vertex a sample, at the heights given [m].
void write_cache(const std::string& path, const std::vector<float>& heights) {
    std::string bytes("POINTCACHE2\0", 12);
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(std::int32_t{1});
    put(std::int32_t{1});
    put(0.0F);
    put(1.0F);
    put(static_cast<std::int32_t>(heights.size()));
    for (const float height : heights) {
        put(0.0F);
        put(height);
        put(0.0F);
    }
    write_file(path, bytes);
}

Verdict verdict_of(const TemporaryFolder& folder, const std::string& result) {
    return compare(folder.file(result), folder.file("reference.png"), {}).files.at(0).verdict;
}

}  // namespace

TEST_CASE("a picture is identical by its pixels, and within the gate by noise but not by a change",
          "[compare]") {
    const TemporaryFolder folder;
    const Image reference = grey();
    write_picture(folder.file("reference.png"), reference);
    write_picture(folder.file("same.png"), reference);
    CHECK(verdict_of(folder, "same.png") == Verdict::identical);

    Image noise = reference;  // of another processor: a level here and there, two pixels more
    for (int i = 0; i < 80; ++i) noise.pixel(5 * i, i)[i % 3] = 101;
    noise.pixel(9, 9)[0] = noise.pixel(50, 50)[0] = 120;
    write_picture(folder.file("noise.png"), noise);
    CHECK(verdict_of(folder, "noise.png") == Verdict::within);

    Image spot = reference;
    for (int x = 0; x < 3; ++x) spot.pixel(x, 0)[1] = 109;
    write_picture(folder.file("spot.png"), spot);
    CHECK(verdict_of(folder, "spot.png") == Verdict::different);

    Image dim = reference;
    for (auto& level : dim.rgb) level = 98;
    write_picture(folder.file("dim.png"), dim);
    CHECK(verdict_of(folder, "dim.png") == Verdict::different);

    write_picture(folder.file("small.png"), grey(200, 250));
    CHECK(verdict_of(folder, "small.png") == Verdict::different);
}

TEST_CASE("folders are compared file by file, and what one side lacks is a difference", "[compare]") {
    const TemporaryFolder ours, wanted;
    for (const char* name : {"frame_0001.png", "frame_0002.png"}) {
        write_picture(ours.file(name), grey());
        write_picture(wanted.file(name), grey());
    }
    write_file(ours.file("report.json"), "{}");  // neither a frame nor a cache
    CHECK(compare(ours.path(), wanted.path(), {}).passed());
    write_picture(ours.file("frame_0003.png"), grey());
    write_picture(wanted.file("frame_0000.png"), grey());
    const Comparison comparison = compare(ours.path(), wanted.path(), {});
    CHECK_FALSE(comparison.passed());
    CHECK(comparison.count(Verdict::identical) == 2);
    CHECK(comparison.count(Verdict::missing) == 1);
    CHECK(comparison.files.back().verdict == Verdict::added);
    const auto json = nlohmann::json::parse(comparison_json(comparison));
    CHECK(json["passed"] == false);
    CHECK(json["files"][0]["name"] == "frame_0000.png");
    CHECK(json["files"][0]["verdict"] == "missing");
}

TEST_CASE("caches pass within rounding and tell a moved light from a changed simulation", "[compare]") {
    const TemporaryFolder ours, wanted;
    write_picture(ours.file("frame_0001.png"), grey());
    Image lit = grey();
    for (auto& level : lit.rgb) level = 140;
    write_picture(wanted.file("frame_0001.png"), lit);
    write_cache(wanted.file("cloth.pc2"), {1.0F, 0.9F, 0.7F});

    write_cache(ours.file("cloth.pc2"), {1.0F, 0.9F, 0.7F + 3e-7F});
    Comparison comparison = compare(ours.path(), wanted.path(), {});
    CHECK(comparison.count(Verdict::within) == 1);
    CHECK(cause_of(comparison).find("only the look") != std::string::npos);

    write_cache(ours.file("cloth.pc2"), {1.0F, 0.9F, 0.701F});
    comparison = compare(ours.path(), wanted.path(), {});
    CHECK(comparison.count(Verdict::different) == 2);
    CHECK(cause_of(comparison).find("from sample 2") != std::string::npos);
    CHECK(compare(ours.file("cloth.pc2"), wanted.file("cloth.pc2"), {.limits = {{"rms", 2e-3}}}).passed());

    write_cache(ours.file("cloth.pc2"), {1.0F, 0.9F});
    comparison = compare(ours.path(), wanted.path(), {});
    CHECK(comparison.files.at(0).why.find("2 samples instead of 3") != std::string::npos);
}

TEST_CASE("limits come from compare.toml beside the references and before that from who asks", "[compare]") {
    const TemporaryFolder ours, wanted;
    Image dim = grey();
    for (auto& level : dim.rgb) level = 98;
    for (const char* name : {"frame_0001.png", "frame_0002.png"}) {
        write_picture(ours.file(name), dim);
        write_picture(wanted.file(name), grey());
    }
    const auto passed = [&](const Asked& asked) {
        std::string verdicts;
        for (const Compared& file : compare(ours.path(), wanted.path(), asked).files)
            verdicts += file.passed() ? 'y' : 'n';
        return verdicts;
    };
    CHECK(passed({}) == "nn");
    write_file(wanted.file("compare.toml"), "mean = 2\n[file.\"frame_0002.png\"]\nmean = 1\n");
    CHECK(passed({}) == "yn");
    CHECK(passed({.limits = {{"mean", 3}}}) == "yy");
    CHECK(passed({.limits = {{"mean", 3}, {"flip", 1e-3}}}) == "nn");
    CHECK(compare(ours.file("frame_0001.png"), wanted.file("frame_0002.png"), {}).passed() == false);
    write_file(wanted.file("compare.toml"), "[file.\"frame_0003.png\"]\nmean = 1\n");
    CHECK(error_of([&] {
              passed({});
          }).find("compare.toml:1:7: unknown file \"frame_0003.png\"; did you mean") != std::string::npos);
}

TEST_CASE("what is ignored does not count and perception is told where it is asked for", "[compare]") {
    const TemporaryFolder folder;
    Image stamped = grey();
    for (int x = 10; x < 60; ++x) stamped.pixel(x, 5)[0] = 255;
    write_picture(folder.file("reference.png"), grey());
    write_picture(folder.file("stamped.png"), stamped);
    const auto one = [&](const Asked& asked) {
        return compare(folder.file("stamped.png"), folder.file("reference.png"), asked).files.at(0);
    };
    CHECK(one({}).verdict == Verdict::different);
    CHECK_FALSE(one({}).perceived);
    CHECK(one({.ignore = {{10, 5, 50, 1}}}).verdict == Verdict::identical);
    CHECK(one({.ignore = {{10, 5, 40, 1}}}).verdict == Verdict::different);
    const Compared seen = one({.perceptual = true});
    REQUIRE(seen.perceived);
    CHECK(seen.perceived->ssim < 1);
    CHECK(seen.perceived->flip > 0);
    CHECK(seen.why.find("% of pixels over 8 levels (at most 0.002 %)") != std::string::npos);
    CHECK(error_of([&] {
              one({.ignore = {{400, 0, 1, 1}}});
          }).find("reference.png: to be ignored: 400,0,1,1: outside") != std::string::npos);
}

TEST_CASE("what cannot be compared is one line", "[compare]") {
    const TemporaryFolder folder;
    write_picture(folder.file("reference.png"), grey());
    write_file(folder.file("broken.png"), "not a picture");
    write_file(folder.file("text.txt"), "x");
    write_cache(folder.file("cloth.pc2"), {1});
    const auto error = [&](const std::string& result) {
        return error_of([&] { compare(folder.file(result), folder.file("reference.png"), {}); });
    };
    CHECK(error("none.png").find("no such file") != std::string::npos);
    CHECK(error("broken.png").find("broken.png") != std::string::npos);
    CHECK(error("text.txt").find(".png, .pc2, .mdd, .glb") != std::string::npos);
    CHECK(error("cloth.pc2").find("a picture against a cache") != std::string::npos);
    CHECK(error(".").find("a file against a folder") != std::string::npos);
    std::filesystem::create_directory(folder.file("empty"));
    CHECK(error_of([&] {
              compare(folder.file("empty"), folder.file("empty"), {});
          }).find("nothing to compare") != std::string::npos);
}
