#include "toml/keys.h"

#include <catch2/catch.hpp>

using namespace drape;

namespace {

// "KEY = VALUE" as the value it holds
Value value_of(const std::string& toml) {
    return parse_toml("x = " + toml, "f").items.at(0);
}

template <class Work>
std::string error_from(Work work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string number_error(const std::string& toml, const Quantity& quantity) {
    return error_from([&] { as_number(value_of(toml), "x", quantity); });
}

}  // namespace

TEST_CASE("lengths and times read with a unit as the same number without one", "[scene]") {
    const auto length = [](const std::string& toml) { return as_number(value_of(toml), "x", any("m")); };
    const auto time = [](const std::string& toml) { return as_number(value_of(toml), "x", any("s")); };
    CHECK(length("3") == 3.0);
    CHECK(length("\"3 mm\"") == 0.003);
    CHECK(length("\"0.7 mm\"") == 0.0007);
    CHECK(length("\"2cm\"") == 0.02);
    CHECK(length("\"-2.5e1  cm\"") == -0.25);
    CHECK(length("\"5 um\"") == 5e-6);
    CHECK(length("\"1 km\"") == 1000);
    CHECK(length("\"1.5 m\"") == 1.5);
    CHECK(time("\"1 s\"") == 1);
    CHECK(time("\"20 ms\"") == 0.02);
    CHECK(time("\"3 us\"") == 3e-6);
    CHECK(time("\"2 min\"") == 120);
}

TEST_CASE("a unit of the wrong dimension, or none, is refused with the right ones", "[scene]") {
    CHECK(number_error("\"3 mm\"", any("s")) ==
          "f:1:5: x: expected a time, such as 0.5 or \"500 ms\", found the text \"3 mm\" (units: s, ms, us, "
          "min)");
    for (const char* wrong :
         {"\"20 s\"", "\"3\"", "\"mm\"", "\"\"", "\"3 mm mm\"", "\"3 feet\"", "\"1e999 m\""}) {
        CAPTURE(wrong);
        CHECK(number_error(wrong, any("m")).find("(units: m, cm, mm, um, km)") != std::string::npos);
    }
    CHECK(number_error("\"3 kg\"", any("kg")) == "f:1:5: x: expected a number, found the text \"3 kg\"");
}

TEST_CASE("numbers that no computation survives are refused with the range", "[scene]") {
    CHECK(number_error("1e15", any("m/s^2")).empty());
    CHECK(number_error("-1.1e15", any("m/s^2")) ==
          "f:1:5: x must be from -1e+15 to 1e+15 m/s^2, got -1.1e+15 m/s^2");
    CHECK(number_error("1e300", positive()) == "f:1:5: x must be from -1e+15 to 1e+15, got 1e+300");
    CHECK(number_error("1e-300", positive("m")) == "f:1:5: x must be at least 1e-15 m, got 1e-300 m");
    CHECK(number_error("1e-300", not_negative("m")).empty());
    CHECK(number_error("-1", positive("m")) == "f:1:5: x must be positive, got -1 m");
}

TEST_CASE("nan and infinity are refused however they are written", "[scene]") {
    for (const char* wrong : {"nan", "inf", "-inf", "\"nan m\"", "\"inf m\""}) {
        CAPTURE(wrong);
        CHECK(number_error(wrong, any("m")).find("x must be a finite number") != std::string::npos);
    }
}

TEST_CASE("a number out of range is refused with what is allowed", "[scene]") {
    CHECK(number_error("0", positive("m")) == "f:1:5: x must be positive, got 0 m");
    CHECK(number_error("-1e-9", not_negative("m")) == "f:1:5: x must be at least 0 m, got -1e-09 m");
    CHECK(number_error("-1", {.least = -1, .most = 0.5, .above_least = true}) ==
          "f:1:5: x must be above -1 and at most 0.5, got -1");
    CHECK(number_error("0.51", {.least = -1, .most = 0.5, .above_least = true}) ==
          "f:1:5: x must be above -1 and at most 0.5, got 0.51");
    CHECK(number_error("9", {.least = 1, .most = 8}) == "f:1:5: x must be from 1 to 8, got 9");
    CHECK(number_error("0.5", {.least = -1, .most = 0.5, .above_least = true}).empty());
    CHECK(number_error("0", not_negative("m")).empty());
}

TEST_CASE("a value of the wrong type is refused with what was expected and what was found", "[scene]") {
    CHECK(number_error("true", any("m")) ==
          "f:1:5: x: expected a length, such as 0.02 or \"2 cm\", found true");
    CHECK(number_error("[1]", any()) == "f:1:5: x: expected a number, found an array of 1");
    CHECK(number_error("1979-05-27", any()) == "f:1:5: x: expected a number, found a date or time");
    CHECK(error_from([] { as_boolean(value_of("1"), "x"); }) ==
          "f:1:5: x: expected true or false, found the integer 1");
    CHECK(error_from([] { as_text(value_of("{}"), "x"); }) == "f:1:5: x: expected a text, found a table");
    CHECK(error_from([] { as_integer(value_of("2.0"), "x", 0, 9); }) ==
          "f:1:5: x: expected an integer, found the number 2");
    CHECK(error_from([] { as_integer(value_of("99999999999"), "x", 0, 9); }) ==
          "f:1:5: x must be from 0 to 9, got 99999999999");
    CHECK(error_from([] { as_vector(value_of("[1, 2]"), "x", any()); }) ==
          "f:1:5: x: expected an array of 3, found an array of 2");
    CHECK(error_from([] { as_vector(value_of("[1, 2, \"a\"]"), "x", any()); }) ==
          "f:1:12: x: expected a number, found the text \"a\"");
}

TEST_CASE("a vector of lengths takes units in each part", "[scene]") {
    CHECK(as_vector(value_of("[1, \"2 cm\", 0.5]"), "x", any("m")) == Vec3(1, 0.02, 0.5));
}

TEST_CASE("a table's keys are known, needed or left alone", "[scene]") {
    const Value table = value_of("{ size = 2, flag = true }");
    const Keys keys(table, "thing", {"size", "flag", "other"});
    double size = 0, other = 5;
    keys.read("size", size, any());
    keys.read("other", other, any());
    CHECK(size == 2);
    CHECK(other == 5);
    CHECK(keys.find("other") == nullptr);
    CHECK(error_from([&] { keys.need("other"); }) == "f:1:5: thing: other is missing");
    CHECK(error_from([&] {
              Keys(table, "thing", {"sizes", "flag"});
          }) == "f:1:7: unknown thing key \"size\"; did you mean \"sizes\"? (known: sizes, flag)");
    CHECK(error_from([] { Keys(value_of("3"), "thing", {}); }) ==
          "f:1:5: thing: expected a table, found the integer 3");
}
