#include "force/colouring.h"

#include <algorithm>
#include <numeric>

namespace drape {

Colouring colour_elements(std::span<const int> vertices, size_t per_element) {
    Colouring colouring;
    const size_t elements = vertices.size() / per_element;
    const int highest = vertices.empty() ? -1 : *std::max_element(vertices.begin(), vertices.end());
    std::vector<int> last(static_cast<size_t>(highest + 1), -1);  // colour that took the vertex last
    std::vector<int> waiting(elements), refused;
    std::iota(waiting.begin(), waiting.end(), 0);
    for (int colour = 0; !waiting.empty(); ++colour) {
        colouring.start.push_back(static_cast<int>(colouring.order.size()));
        refused.clear();
        for (const int element : waiting) {
            const auto own = vertices.subspan(static_cast<size_t>(element) * per_element, per_element);
            const auto taken = [&](int vertex) { return last[static_cast<size_t>(vertex)] == colour; };
            if (std::any_of(own.begin(), own.end(), taken)) {
                refused.push_back(element);
                continue;
            }
            for (const int vertex : own) last[static_cast<size_t>(vertex)] = colour;
            colouring.order.push_back(element);
        }
        waiting.swap(refused);
    }
    colouring.start.push_back(static_cast<int>(colouring.order.size()));
    return colouring;
}

}  // namespace drape
