#include "force/colouring.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

TEST_CASE("elements of a colour share no vertex, and every element has one", "[force]") {
    const Mesh mesh = square(9);
    const std::vector<int> corners(mesh.faces.data(), mesh.faces.data() + mesh.faces.size());
    const Colouring colouring = colour_elements(corners, 3);
    CHECK(colouring.colours() <= 10);  // eight triangles meet at some vertices; measured 8
    CHECK(std::set(colouring.order.begin(), colouring.order.end()).size() == corners.size() / 3);
    CHECK(colouring.order.size() == corners.size() / 3);
    for (int c = 0; c < colouring.colours(); ++c) {
        const auto from = colouring.order.begin() + colouring.start[static_cast<size_t>(c)];
        const auto to = colouring.order.begin() + colouring.start[static_cast<size_t>(c) + 1];
        std::set<int> touched;
        for (auto element = from; element != to; ++element)
            for (int k = 0; k < 3; ++k) CHECK(touched.insert(mesh.faces(k, *element)).second);
        CHECK(std::is_sorted(from, to));
    }
}

TEST_CASE("many elements around one vertex take a colour each; none take none", "[force]") {
    std::vector<int> star;
    for (int i = 1; i <= 200; ++i) star.insert(star.end(), {0, i});
    CHECK(colour_elements(star, 2).colours() == 200);
    CHECK(colour_elements({}, 2).colours() == 0);
}
