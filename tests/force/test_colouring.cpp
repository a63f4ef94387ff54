#include "force/colouring.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
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

TEST_CASE("elements are spread so that those at one vertex are seldom near each other", "[force]") {
    const Mesh mesh = square(20);
    const std::vector<int> corners(mesh.faces.data(), mesh.faces.data() + mesh.faces.size());
    const auto near_neighbours = [&](const std::vector<int>& order) {
        int found = 0;
        for (size_t i = 1; i < order.size(); ++i)
            for (size_t j = i > 4 ? i - 4 : 0; j < i; ++j)
                for (int k = 0; k < 9; ++k)
                    found += mesh.faces(k / 3, order[i]) == mesh.faces(k % 3, order[j]);
        return found;
    };
    std::vector<int> given(corners.size() / 3);
    std::iota(given.begin(), given.end(), 0);
    const std::vector<int> order = spread_elements(corners, 3);
    CHECK(std::is_permutation(order.begin(), order.end(), given.begin(), given.end()));
    CHECK(near_neighbours(order) < near_neighbours(given) / 10);
    for (size_t i = 0; i < order.size(); ++i) CHECK(std::abs(order[i] - static_cast<int>(i)) < 64);
    CHECK(spread_elements({}, 3).empty());
}
