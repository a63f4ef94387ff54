// The page that compare leaves, opened in a browser.
#include <set>

#include <catch2/catch.hpp>

#include "app/two_runs.h"
#include "support/browser.h"

using namespace drape;
using namespace drape::test;

namespace {

// Uses the page as people do and writes down what it then shows, a line "step: what" each.
constexpr const char* self_check = R"script(<pre id="checked"></pre><script>
window.addEventListener('load', () => {
  const lines = [];
  const article = () => document.querySelector('article.here');
  const stage = () => article().querySelector('.stage');
  const visible = () => [...stage().querySelectorAll('figure')]
    .filter(f => f.getClientRects().length && getComputedStyle(f).visibility === 'visible').map(f => f.className).join(' ');
  const press = key => document.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
  const cut = () => getComputedStyle(stage().querySelector('.reference img')).clipPath;
  const say = (step, what) => lines.push(step + ': ' + what);
  const name = () => article().querySelector('h2').firstChild.textContent.trim();
  const pictures = [...document.querySelectorAll('img')];
  say('pictures', pictures.length + ', loaded ' + pictures.filter(p => p.complete && p.naturalWidth > 0).length);
  say('articles seen', [...document.querySelectorAll('article')].filter(a => a.getClientRects().length).length);
  say('first', name() + ', ' + visible());
  press('2'); say('slider', visible() + ', ' + cut());
  for (let i = 0; i < 5; ++i) press('ArrowRight'); say('slid by keys', cut());
  const slider = article().querySelector('input');
  slider.value = 20; slider.dispatchEvent(new Event('input')); say('slid by hand', cut());
  const box = stage().querySelector('img').getBoundingClientRect();
  stage().dispatchEvent(new PointerEvent('pointermove', {pointerType: 'mouse', clientX: box.left + 0.75 * box.width}));
  say('slid by pointer', cut());
  press('3'); say('blink', visible());
  press(' '); say('blinked', visible());
  press(' '); say('blinked back', visible());
  press('4'); say('difference', visible());
  article().querySelectorAll('button')[4].click(); say('perception', visible());
  press('ArrowDown'); say('down', name() + ', ' + visible() + ', ' + location.hash);
  press('j'); press('j'); say('last', name() + ', ' + visible());
  press('k'); say('up', name());
  press('Home'); say('home', name() + ', ' + visible());
  document.querySelectorAll('.frames nav a')[2].click(); say('clicked', name());
  location.hash = document.querySelector('svg a').getAttribute('href');
  setTimeout(() => {
    say('from the timeline', name());
    document.getElementById('checked').textContent = lines.join('\n') + '\n';
  }, 100);
});
</script></body>)script";

std::string with(std::string page, const std::string& addition) {
    const size_t end = page.rfind("</body>");
    REQUIRE(end != std::string::npos);
    return page.replace(end, 7, addition);
}

std::string checked_lines(const std::string& dom) {
    const std::string start = "<pre id=\"checked\">";
    const size_t begin = dom.find(start);
    return begin == std::string::npos
               ? ""
               : dom.substr(begin + start.size(), dom.find("</pre>", begin) - begin - start.size());
}

}  // namespace

TEST_CASE("a comparison's page works in a browser by slider and views and keys", "[app]") {
    if (skipped_without_browser()) return;
    const TwoRuns runs;
    REQUIRE(runs.compare({"--html", "page.html"}).exit_code == 1);
    const std::string page = bytes_of(runs.folder.file("page.html"));
    const Visit used = visit(runs.folder.file("used.html", with(page, self_check)));
    CHECK(used.exit_code == 0);
    CHECK(used.console == "");
    CHECK(checked_lines(used.dom) ==
          "pictures: 6, loaded 6\n"
          "articles seen: 1\n"
          "first: frame_0002.png, result reference\n"
          "slider: result reference, inset(0px 0px 0px 50%)\n"
          "slid by keys: inset(0px 0px 0px 60%)\n"
          "slid by hand: inset(0px 0px 0px 20%)\n"
          "slid by pointer: inset(0px 0px 0px 75%)\n"
          "blink: result\n"
          "blinked: result reference\n"
          "blinked back: result\n"
          "difference: difference\n"
          "perception: perception\n"
          "down: frame_0003.png, result, #f2\n"
          "last: frame_0004.png, reference\n"
          "up: frame_0003.png\n"
          "home: frame_0002.png, perception\n"
          "clicked: frame_0004.png\n"
          "from the timeline: frame_0002.png\n");
}

TEST_CASE("a comparison's page opens without complaint and shows something", "[app]") {
    if (skipped_without_browser()) return;
    const TwoRuns runs;
    REQUIRE(runs.compare({"--html", "page.html"}).exit_code == 1);
    const std::string picture = runs.folder.file("shot.png");
    const Visit seen = visit(runs.folder.file("page.html"), picture);
    CHECK(seen.exit_code == 0);
    CHECK(seen.console == "");
    const Image shot = read_png(picture);
    CHECK(shot.width == 1200);
    std::set<std::array<std::uint8_t, 3>> colours;
    int dark = 0;
    for (int y = 0; y < shot.height; ++y) {
        for (int x = 0; x < shot.width; ++x) {
            const std::uint8_t* p = shot.pixel(x, y);
            colours.insert({p[0], p[1], p[2]});
            dark += p[0] + p[1] + p[2] < 30;
        }
    }
    CHECK(colours.size() > 50);
    CHECK(dark > 50000);  // the pictures' black grounds
    // and complaints would be seen
    const std::string page = bytes_of(runs.folder.file("page.html"));
    const std::string broken =
        with(page, "<script>no_such_name();</script><img src=\"https://example.com/x.png\"></body>");
    const Visit complained = visit(runs.folder.file("broken.html", broken));
    CHECK_THAT(complained.console,
               Catch::Contains("no_such_name") && Catch::Contains("Content Security Policy"));
}
