#include "video/sequence.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/frames.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Matchers::Contains;

namespace {

std::string complaint(const std::string& folder) {
    try {
        find_sequence(folder);
    } catch (const Error& error) {
        CHECK(error.code() == Exit::bad_input);
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a sequence is the numbered pictures of a folder, in the order of their numbers", "[video]") {
    const TemporaryFolder folder;
    write_frames(folder.path(), 12, 16, 9, "frame_", 95);  // 0095 to 0106
    folder.file("report.json", "{}");
    folder.file("plot.png", "");
    folder.file("other_1.png", "");
    const Sequence sequence = find_sequence(folder.path());
    REQUIRE(sequence.frames() == 12);
    CHECK(sequence.first == 95);
    CHECK(sequence.files[0] == folder.file("frame_0095.png"));
    CHECK(sequence.files[11] == folder.file("frame_0106.png"));
    CHECK(sequence.width == 16);
    CHECK(sequence.height == 9);
}

TEST_CASE("numbers need no zeros in front, and any one name will do", "[video]") {
    const TemporaryFolder folder;
    for (const int k : {8, 9, 10, 11})
        write_file(folder.file("IMG" + std::to_string(k) + ".PNG"), encode_png(moving_disc(k, 8, 8)));
    CHECK(find_sequence(folder.path()).files[2] == folder.file("IMG10.PNG"));
    write_frames(folder.path(), 1, 8, 8, "view");
    CHECK_THAT(complaint(folder.path()),
               Contains("more than one sequence") && Contains("IMG8.PNG") && Contains("view0001.png"));
}

TEST_CASE("what is missing from a sequence or does not fit is named", "[video]") {
    const TemporaryFolder folder;
    CHECK_THAT(complaint(folder.file("none")), Contains("none: no such folder"));
    CHECK_THAT(complaint(folder.file("a.png", "x")), Contains("a.png: is not a folder"));
    CHECK_THAT(complaint(folder.path()), Contains("no numbered PNG pictures"));

    write_frames(folder.path(), 6, 16, 9);
    std::filesystem::remove(folder.file("frame_0003.png"));
    CHECK_THAT(complaint(folder.path()), Contains("frame 3 is missing between frame_0002.png and"));
    std::filesystem::remove(folder.file("frame_0004.png"));
    CHECK_THAT(complaint(folder.path()),
               Contains("frames 3 to 4 are missing between frame_0002.png and frame_0005.png"));

    write_frames(folder.path(), 6, 16, 9);
    write_file(folder.file("frame_0005.png"), encode_png(moving_disc(0, 17, 9)));
    CHECK_THAT(complaint(folder.path()),
               Contains("frame_0005.png: is 17x9 pixels, the frames before it 16x9"));
    folder.file("frame_0005.png", "no picture at all, but longer than a header");
    CHECK_THAT(complaint(folder.path()), Contains("frame_0005.png: is not a PNG picture"));
    folder.file("frame_5.png", "");
    CHECK_THAT(complaint(folder.path()), Contains("has the same number as"));
}
