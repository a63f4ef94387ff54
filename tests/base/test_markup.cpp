#include "base/markup.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("text cannot leave an element or an attribute", "[base]") {
    CHECK(escaped("<b a=\"1\" c='2'>&amp;") == "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
}

TEST_CASE("what XML allows nowhere becomes a question mark", "[base]") {
    CHECK(escaped(std::string("a\0b\x01\x1b[31m\x7f", 10)) == "a?b??[31m?");
    CHECK(escaped("two\tlines\n") == "two\tlines\n");
    CHECK(escaped("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\xa7\xb5") ==
          "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\xa7\xb5");
    CHECK(escaped("\xc3") == "?");                 // cut off
    CHECK(escaped("\xc3<") == "?&lt;");            // the next byte keeps its meaning
    CHECK(escaped("\xc0\xbc") == "??");            // "<" in two bytes
    CHECK(escaped("\xed\xa0\x80") == "???");       // half of a surrogate pair
    CHECK(escaped("\xf4\x90\x80\x80") == "????");  // beyond Unicode
    CHECK(escaped("\xef\xbf\xbe") == "???");       // no character
}
