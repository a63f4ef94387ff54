// A fuzzer of the reader that FUZZED_READER names (libFuzzer has main).
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fuzz/readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto read = [] {
        for (const drape::test::FuzzedReader& reader : drape::test::fuzzed_readers())
            if (reader.name == FUZZED_READER) return reader.read;
        std::abort();
    }();
    read({reinterpret_cast<const char*>(data), size});
    return 0;
}
