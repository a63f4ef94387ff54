// Every reader of what a stranger may have made, as a function of bytes: what a fuzzer drives (fuzz.cpp), and
// what a test replays past findings on (test_findings.cpp).
#pragma once

#include <span>
#include <string_view>

namespace drape::test {

struct FuzzedReader {
    std::string_view name;  // also of the folder of its findings, tests/data/fuzz/NAME
    // Reads the bytes. Returns where they were read or refused with an Error; what is read but wrong aborts.
    void (*read)(std::string_view bytes);
};

std::span<const FuzzedReader> fuzzed_readers();

}  // namespace drape::test
