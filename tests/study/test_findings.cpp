// The cheapest way to an error, and numbers as people read them.
#include <catch2/catch.hpp>

#include "base/numbers.h"
#include "study/findings.h"

using namespace drape;

namespace {

Rung rung_of(double step, double error, double cpu) {
    Rung rung;
    rung.method = &method_named("verlet");
    rung.step = step;
    rung.errors.final_rms = error;
    rung.cpu = {cpu};
    return rung;
}

// Errors of order two, which end at the bar.
Study second_order() {
    Study study;
    study.reference.bar = {{1e-6, 2e-6}};
    for (const double h : {8e-3, 4e-3, 2e-3, 1e-3, 5e-4})
        study.rungs.push_back(rung_of(h, std::max(h * h, 1e-6), 1e-3 / h));
    return study;
}

}  // namespace

TEST_CASE("the cheapest rung under an error is found, or none", "[study]") {
    const Study study = second_order();
    CHECK(cheapest_under(study, 2e-5)->step == 4e-3);
    CHECK(cheapest_under(study, 1e-9) == nullptr);
    CHECK(representative(study, method_named("verlet"), 1e-9)->step == 1e-3);
}

TEST_CASE("the order is read from rungs clear of the bar alone", "[study]") {
    const SeenOrder order = seen_order(second_order(), method_named("verlet"));
    CHECK(order.rungs == 3);
    CHECK(*order.seen == Approx(2));
}

TEST_CASE("lengths and times are written in the unit that suits them", "[study]") {
    CHECK(length_text(5.9e-4) == "590 µm");
    CHECK(length_text(0.01) == "10 mm");
    CHECK(length_text(1e-3) == "1 mm");
    CHECK(time_text(8.3e-5) == "83 µs");
    CHECK(length_text(NAN) == "-");
}
