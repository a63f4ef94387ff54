// The verb `gallery` on scenes of a few triangles.
#include <filesystem>

#include <catch2/catch.hpp>

#include "support/browser.h"
#include "support/ffmpeg.h"
#include "support/run_program.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;
using Catch::Matchers::Contains;

#ifdef DRAPE_WITH_RENDER

namespace {

namespace fs = std::filesystem;

constexpr const char* small_sheet =
    "schema = 1\n[scene]\nname = \"a <small> sheet\"\nduration = 0.4\nframe_rate = 10\n[[cloth]]\n"
    "pattern = { name = \"alternating\", divisions = [6, 6] }\nfabric = \"cotton\"\n"
    "[render]\ncamera = { from = [1, 1, 2], at = [0, -0.2, 0], fov_deg = 45 }\n";

std::string catalogue(const std::string& more = "") {
    return "schema = 1\n[[piece]]\nscene = \"sheet.toml\"\nsize = [96, 64]\nsays = \"It falls.\"\n" + more;
}

constexpr const char* two_panes =
    "[[piece]]\nscene = \"sheet.toml\"\nname = \"two\"\ntitle = \"Two\"\nsize = [96, 64]\n"
    "[[piece.pane]]\nlabel = \"cotton\"\n[[piece.pane]]\nlabel = \"wool\"\nset = "
    "[\"cloth.0.fabric=wool\"]\n";

}  // namespace

TEST_CASE("a gallery has looping pictures and posters and costs of every piece", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    folder.file("sheet.toml", small_sheet);
    const std::string file = folder.file("gallery.toml", catalogue(two_panes)), out = folder.file("page");
    const Ran ran = run_drape({"gallery", file, "--out", out});
    CAPTURE(ran.err);
    REQUIRE(ran.exit_code == 0);
    CHECK_THAT(ran.out, Contains(out + "/index.html"));
    const std::string page = bytes_of(out + "/index.html");
    CHECK_THAT(page, Contains("a &lt;small&gt; sheet") && Contains("It falls.") && Contains("49 vertices"));
    CHECK_THAT(page, Contains("--set cloth.0.fabric=wool --size 96x64 --out runs/two/2"));
    CHECK_THAT(page, Contains("drape video runs/two/1 runs/two/2 --side-by-side --label cotton --label wool "
                              "--no-caption --at-most 1.5 --out two.webp"));
    CHECK(bytes_of(out + "/two.webp").substr(8, 4) == "WEBP");
    CHECK_FALSE(fs::exists(out + "/runs/sheet/frame_0001.png"));

    SECTION("what has not changed is left alone and what has is made again") {
        const auto sheet = fs::last_write_time(out + "/sheet.webp"),
                   two = fs::last_write_time(out + "/two.webp");
        std::string changed = two_panes;
        changed.replace(changed.find("=wool"), 5, "=wool_lycra");
        folder.file("gallery.toml", catalogue(changed));
        const Ran again = run_drape({"gallery", file, "--out", out});
        CHECK(again.exit_code == 0);
        CHECK_THAT(again.err, Contains("sheet: is as it was"));
        CHECK(fs::last_write_time(out + "/sheet.webp") == sheet);
        CHECK(fs::last_write_time(out + "/two.webp") > two);
    }
    SECTION("it opens in a browser with every picture") {
        if (skipped_without_browser()) return;
        // which of the two is shown depends on what the window reaches
        const std::string check =
            "<pre id=\"checked\"></pre><script>addEventListener('load', () => { const all = "
            "[...document.querySelectorAll('img')].flatMap(i => [i.dataset.poster, i.dataset.loop]).map(file "
            "=> Object.assign(new Image(), {src: file})); setTimeout(() => {"
            "document.getElementById('checked').textContent = all.map(i => i.complete + ' ' + "
            "i.naturalWidth + ' ' + i.getAttribute('src')).join('; ') + '.';}, 1000);});</script></body>";
        std::string with_check = page;
        with_check.replace(with_check.rfind("</body>"), 7, check);
        const Visit seen = visit(folder.file("page/checked.html", with_check));
        CHECK(seen.console == "");
        CHECK_THAT(seen.dom, Contains("<pre id=\"checked\">true 96 sheet.png; true 96 sheet.webp; true 194 "
                                      "two.png; true 194 two.webp.</pre>"));
    }
}

TEST_CASE("a piece that fails is named on the page of the others and by the exit code", "[app]") {
    if (skipped_without_ffmpeg()) return;
    const TemporaryFolder folder;
    folder.file("sheet.toml", small_sheet);
    const std::string file =
        folder.file("gallery.toml", catalogue("[[piece]]\nscene = \"sheet.toml\"\nname = \"torn\"\nset = "
                                              "[\"cloth.0.pins=[{ near = [9, 9, 9] }]\"]\n"));
    const std::string out = folder.file("page");
    const Ran ran = run_drape({"gallery", file, "--out", out, "--quick", "--quiet"});
    CHECK(ran.exit_code == 4);
    CHECK(ran.error_lines() == 1);
    CHECK_THAT(ran.err, Contains("gallery: not made: torn"));
    const std::string page = bytes_of(out + "/index.html");
    CHECK_THAT(page, Contains("Not made:") && Contains("pin matches nothing") && Contains("sheet.webp"));
    CHECK_THAT(page, Contains("--frames 1:4 --size 48x32"));
    const Ran unknown = run_drape({"gallery", file, "--only", "shet", "--out", folder.file("other")});
    CHECK(unknown.exit_code == 2);
    CHECK_THAT(unknown.err, Contains("did you mean \"sheet\"?"));
    CHECK_FALSE(fs::exists(folder.file("other")));
}

#endif
