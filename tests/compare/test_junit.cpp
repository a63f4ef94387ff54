#include "compare/junit.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("a JUnit file has a case for each file and a failure for each that differs", "[compare]") {
    Comparison comparison;
    comparison.files = {
        {.name = "frame_0001.png"},
        {.name = "frame_0002.png", .verdict = Verdict::within},
        {.name = "a<b>&\"c\".png", .verdict = Verdict::different, .why = "1 < 2 & \x01"},
        {.name = "frame_0004.png", .verdict = Verdict::missing, .why = "only in the reference"}};
    CHECK(
        junit_report(comparison, "it's <flag>") ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<testsuites tests=\"4\" failures=\"2\" errors=\"0\">\n"
        "  <testsuite name=\"it&#39;s &lt;flag&gt;\" tests=\"4\" failures=\"2\" errors=\"0\" skipped=\"0\">\n"
        "    <testcase classname=\"it&#39;s &lt;flag&gt;\" name=\"frame_0001.png\"/>\n"
        "    <testcase classname=\"it&#39;s &lt;flag&gt;\" name=\"frame_0002.png\"/>\n"
        "    <testcase classname=\"it&#39;s &lt;flag&gt;\" "
        "name=\"a&lt;b&gt;&amp;&quot;c&quot;.png\"><failure "
        "type=\"different\" message=\"1 &lt; 2 &amp; ?\"/></testcase>\n"
        "    <testcase classname=\"it&#39;s &lt;flag&gt;\" name=\"frame_0004.png\"><failure type=\"missing\" "
        "message=\"only in the reference\"/></testcase>\n"
        "  </testsuite>\n</testsuites>\n");
}
