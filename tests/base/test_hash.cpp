#include "base/hash.h"

#include <catch2/catch.hpp>

using namespace drape;

TEST_CASE("the hash of known texts is the published FNV-1a one", "[base]") {
    CHECK(hash_text(hash_bytes("", 0)) == "cbf29ce484222325");
    CHECK(hash_text(hash_bytes("a", 1)) == "af63dc4c8601ec8c");
    CHECK(hash_text(hash_bytes("foobar", 6)) == "85944171f73967e8");
}

TEST_CASE("hashing in pieces is hashing the whole", "[base]") {
    CHECK(hash_bytes("bar", 3, hash_bytes("foo", 3)) == hash_bytes("foobar", 6));
}
