#include "io/isolated.h"

#include <catch2/catch.hpp>
#include <csignal>
#include <new>

#include "support/meshes.h"

using namespace drape;

namespace {

constexpr Limits plenty{1ULL << 30, 10};

}  // namespace

TEST_CASE("what isolated work returns comes back whole, however long", "[io]") {
    const std::string text(3'000'000, 'x');
    CHECK(run_isolated(plenty, [&] { return text; }) == text);
    CHECK(run_isolated(plenty, [] { return std::string(); }).empty());
}

TEST_CASE("isolated work that throws, crashes or runs out of time or memory is an error and no more",
          "[io]") {
    const auto outcome = [](const Limits& limits, const std::function<std::string()>& work) {
        return error_of([&] { run_isolated(limits, work); });
    };
    CHECK(outcome(plenty, []() -> std::string { throw Error("a line too many"); }) == "a line too many");
    CHECK(outcome(plenty, []() -> std::string { throw std::bad_alloc(); }) ==
          "needs more than 1024 MB of memory");
    CHECK(outcome(plenty, [] {
              std::raise(SIGSEGV);
              return std::string();
          }) == "crashes the reader");
    CHECK(outcome({1ULL << 30, 1}, []() -> std::string {
              const volatile bool forever = true;
              while (forever) continue;
              return "";
          }) == "needs more than 1 s");
}
