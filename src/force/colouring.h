// Colours of elements (springs, triangles): elements of one colour share no vertex, so a sweep that changes
// vertices as it goes gives the same result in whatever order it takes a colour's elements, or all at once.
#pragma once

#include <span>
#include <vector>

namespace drape {

struct Colouring {
    std::vector<int> order;  // of the elements, colour after colour; within a colour as they were given
    std::vector<int> start;  // of each colour in `order`, and the end: one longer than there are colours

    int colours() const { return static_cast<int>(start.size()) - 1; }
};

// First fit: the least colour that no earlier element at any of its vertices has. `vertices` holds
// `per_element` for each.
Colouring colour_elements(std::span<const int> vertices, size_t per_element);

// An order in which an element seldom shares a vertex with one of the few before it, so that a sweep that
// adds to its vertices seldom waits for the element before to have stored; never far from the order given, so
// that it stays in the cache's reach.
std::vector<int> spread_elements(std::span<const int> vertices, size_t per_element);

}  // namespace drape
