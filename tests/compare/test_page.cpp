#include "compare/page.h"

#include <filesystem>

#include <catch2/catch.hpp>

#include "compare/pictures.h"
#include "io/png.h"
#include "io/write_file.h"
#include "support/markup.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Contains;

namespace {

std::string without_pictures(const std::string& page) {
    std::string text;
    size_t at = 0;
    for (size_t data; (data = page.find("base64,", at)) != std::string::npos; at = page.find('"', data))
        text += page.substr(at, data - at);
    return text + page.substr(at);
}

}  // namespace

TEST_CASE("the page is well formed and needs nothing else and escapes every name", "[compare]") {
    const TemporaryFolder folder;
    const std::string ours = folder.file("<b>ours & co"), wanted = folder.file("want\"ed");
    std::filesystem::create_directory(ours);
    std::filesystem::create_directory(wanted);
    const auto write = [](const std::string& path, const Image& image) {
        write_file(path, encode_png(image));
    };
    const std::string odd = "frame_<i>'\"&.png";
    write(ours + "/" + odd, disc(60, 40, 30, 20, 10));
    write(wanted + "/" + odd, disc(60, 40, 34, 20, 10));
    write(ours + "/frame_0002.png", plain(60, 40));
    write(wanted + "/frame_0003.png", plain(60, 40));
    const PageRequest request{ours, wanted, {}, "drape compare '<b>ours & co' x --accept", "drape 1 & <2>"};
    const std::string page = comparison_page(compare(ours, wanted, {}), request);
    const std::string text = without_pictures(page);
    CHECK_THAT(text, !Contains("<b>") && !Contains("<i>") && !Contains("<2>") && !Contains("want\"ed"));
    CHECK_THAT(text, Contains("frame_&lt;i&gt;&#39;&quot;&amp;.png"));
    CHECK_THAT(
        text,
        Contains("<code id=\"accept\">drape compare &#39;&lt;b&gt;ours &amp; co&#39; x --accept</code>"));
    CHECK_THAT(text, Contains("first bad: frame_0002.png") && Contains("1 different, 1 missing, 1 added"));
    CHECK_THAT(text, !Contains("http://") && !Contains("https://") && !Contains("src=\"/"));
    const size_t script = text.find("<script>\n");
    CHECK(unbalanced(text.substr(0, script)) == "body");
    for (const char* section :
         {"<article id=\"f", "class=\"histogram\"", "All that is not identical", "FLIP", "SSIM"})
        CHECK_THAT(text, Contains(section));
}

TEST_CASE("a page of caches draws their samples and one of the same results has nothing to accept",
          "[compare]") {
    Comparison comparison{
        {{.name = "cloth.pc2",
          .verdict = Verdict::different,
          .why = "far off",
          .cache = CacheDifference{.sample = 2, .rms_m = 1e-2, .rms_each = {0, 1e-7, 1e-2}}}},
        {{"rms", 1e-6}}};
    const PageRequest request{"a", "b", {}, "drape compare a b --accept", "drape"};
    CHECK_THAT(comparison_page(comparison, request),
               Contains("Positions of cloth.pc2") && Contains("first bad: sample 2") && Contains("10 mm"));
    Comparison same{{{.name = "frame_0001.png"}}, {}};
    CHECK_THAT(comparison_page(same, request),
               !Contains("--accept") && Contains("passed\">same</span>: 1 identical"));
}
