#include "study/collapse.h"

#include <catch2/catch.hpp>

using namespace drape;

namespace {

const Recovery& of(const std::vector<Recovery>& recoveries, AltitudeMode mode, Collapse start) {
    for (const Recovery& r : recoveries)
        if (r.mode == mode && r.start == start) return r;
    throw std::logic_error("a mode is missing");
}

double share(const Recovery& r) {
    return double(r.recovered) / r.collapsed;
}

}  // namespace

TEST_CASE("collapsed triangles come back, by altitude mode", "[study]") {
    const std::vector<Recovery> recoveries = measure_recovery(1);
    REQUIRE(recoveries.size() == 15);
    for (const Recovery& r : recoveries) {
        CAPTURE(static_cast<int>(r.mode), name_of(r.start));
        CHECK(r.collapsed > 10);
        CHECK(r.collapsed == of(recoveries, AltitudeMode::none, r.start).collapsed);
        CHECK(r.recovered <= r.collapsed);
        // all altitudes at once are in each other's way, as the notes warn
        if (r.mode != AltitudeMode::all) CHECK(r.stopped == 0);
    }
    for (const CollapseKind& kind : collapse_kinds) {
        const double blend = share(of(recoveries, AltitudeMode::blend, kind.collapse));
        CAPTURE(kind.name, blend);
        CHECK(blend >= share(of(recoveries, AltitudeMode::all, kind.collapse)));
    }
    const std::vector<std::string> lines = recovery_summary(recoveries);
    REQUIRE(lines.size() == collapse_kinds.size());
    CHECK_THAT(lines[0], Catch::Contains("in plane: none ") && Catch::Contains(" %, all "));
    CHECK(recovery_summary({}).empty());
    CHECK_THAT(recovery_csv(recoveries),
               Catch::StartsWith("altitude,start,collapsed,recovered,runs_stopped\nnone,thrown in plane,"));
}
