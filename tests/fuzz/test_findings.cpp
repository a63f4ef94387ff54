// What fuzzers found, and what they start from, is read or refused as it should be.
#include <filesystem>

#include <catch2/catch.hpp>

#include "fuzz/readers.h"
#include "support/temporary_folder.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("every file that a fuzzer starts from or stumbled over is read or refused", "[scene]") {
    for (const FuzzedReader& reader : fuzzed_readers()) {
        int files = 0;
        for (const auto& entry :
             std::filesystem::directory_iterator(TEST_DATA "/fuzz/" + std::string(reader.name))) {
            CAPTURE(entry.path().string());
            CHECK_NOTHROW(reader.read(bytes_of(entry.path().string())));
            ++files;
        }
        CAPTURE(reader.name);
        CHECK(files > 0);
    }
}
