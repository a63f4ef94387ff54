#include "compare/accept.h"

#include <filesystem>

#include <catch2/catch.hpp>

#include "compare/pictures.h"
#include "io/png.h"
#include "io/write_file.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("accepting writes what differs and removes what went and leaves alone what passed", "[compare]") {
    const TemporaryFolder ours, wanted;
    const auto write = [](const std::string& path, const Image& image) {
        write_file(path, encode_png(image));
    };
    Image almost = plain(200, 200);
    almost.pixel(3, 3)[0] = 101;
    write(ours.file("frame_0001.png"), almost);
    write(wanted.file("frame_0001.png"), plain(200, 200));
    const std::string kept = bytes_of(wanted.file("frame_0001.png"));
    write(ours.file("frame_0002.png"), plain(200, 200, 7));
    write(wanted.file("frame_0002.png"), plain(200, 200));
    write(ours.file("frame_0003.png"), plain(200, 200));
    write(wanted.file("frame_0004.png"), plain(200, 200));
    accept(compare(ours.path(), wanted.path(), {}), ours.path(), wanted.path());
    const Comparison after = compare(ours.path(), wanted.path(), {});
    CHECK(after.passed());
    CHECK(after.count(Verdict::within) == 1);
    CHECK(bytes_of(wanted.file("frame_0001.png")) == kept);
    CHECK(wanted.files() == 3);
    CHECK_FALSE(std::filesystem::exists(wanted.file("frame_0004.png")));
}

TEST_CASE("one picture is accepted under the reference's own name", "[compare]") {
    const TemporaryFolder folder;
    write_file(folder.file("new.png"), encode_png(plain(20, 20, 9)));
    write_file(folder.file("old.png"), encode_png(plain(20, 20)));
    accept(compare(folder.file("new.png"), folder.file("old.png"), {}), folder.file("new.png"),
           folder.file("old.png"));
    CHECK(bytes_of(folder.file("new.png")) == bytes_of(folder.file("old.png")));
}
