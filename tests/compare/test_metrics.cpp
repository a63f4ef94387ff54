#include "compare/metrics.h"

#include <set>

#include <catch2/catch.hpp>

#include "base/error.h"
#include "support/meshes.h"
#include "support/temporary_folder.h"

using namespace drape;

TEST_CASE("every metric has a key of its own and tells a number of its own", "[compare]") {
    Compared file;
    for (const Metric& metric : metrics()) CHECK_FALSE(metric.value(file));
    file.picture = PictureDifference{.mean_levels = 1, .share_over = 2, .share_off_edges = 3, .density = 4};
    file.perceived = {5, 6};
    file.cache = CacheDifference{.rms_m = 7, .most_m = 8, .hausdorff_m = 9};
    std::set<std::string_view> keys;
    std::set<double> values;
    for (const Metric& metric : metrics()) {
        CAPTURE(std::string(metric.key));
        CHECK_FALSE(metric.says.empty());
        keys.insert(metric.key);
        values.insert(metric.value(file).value());
        CHECK(&metric_of(metric.key) == &metric);
    }
    CHECK(keys.size() == metrics().size());
    CHECK(values.size() == metrics().size());
}

TEST_CASE("a metric exceeds its limit upwards but similarity downwards", "[compare]") {
    CHECK(exceeds(metric_of("mean"), 3, 2));
    CHECK_FALSE(exceeds(metric_of("mean"), 2, 2));
    CHECK(exceeds(metric_of("ssim"), 0.9, 0.95));
    CHECK_FALSE(exceeds(metric_of("ssim"), 1, 0.95));
    CHECK(exceeds(metric_of("rms"), std::nan(""), 1));
}

TEST_CASE("numbers are written with their unit", "[compare]") {
    CHECK(metric_text(metric_of("share"), 2e-5) == "0.002 %");
    CHECK(metric_text(metric_of("mean"), 0.00351) == "0.00351 levels");
    CHECK(metric_text(metric_of("ssim"), 0.98765) == "0.9877");
    CHECK(metric_text(metric_of("rms"), 1e-6) == "1 µm");
    CHECK(metric_text(metric_of("rms"), 0) == "0 m");
}

TEST_CASE("an unknown metric is told with the nearest", "[compare]") {
    CHECK(error_of([] { metric_of("densty"); }).find("did you mean \"density\"?") != std::string::npos);
}

TEST_CASE("the README and the man page know every metric", "[compare]") {
    const std::string source = DRAPE_SOURCE_DIR;
    const std::string readme = bytes_of(source + "/README.md"), man = bytes_of(source + "/src/app/drape.1");
    for (const Metric& metric : metrics()) {
        CHECK_THAT(readme, Catch::Contains(cat("| `", metric.key, "` |")));
        CHECK_THAT(man, Catch::Contains(cat("\\fI", metric.key, "\\fR")));
        if (!metric.asked_by.empty()) CHECK_THAT(readme, Catch::Contains(cat("`", metric.asked_by, "`")));
    }
}
