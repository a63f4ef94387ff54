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

std::vector<int> spread_elements(std::span<const int> vertices, size_t per_element) {
    constexpr size_t window = 64;  // elements that change places; measured, as is the next
    constexpr int apart = 16;      // elements between two at the same vertex are enough
    const size_t elements = vertices.size() / per_element;
    const int highest = vertices.empty() ? -1 : *std::max_element(vertices.begin(), vertices.end());
    std::vector<int> last(static_cast<size_t>(highest + 1), -apart);  // place of the vertex's last element
    std::vector<int> order, left;
    const auto wait = [&](int element) {
        int least = apart;
        for (const int v : vertices.subspan(static_cast<size_t>(element) * per_element, per_element))
            least = std::min(least, static_cast<int>(order.size()) - last[static_cast<size_t>(v)]);
        return least;
    };
    for (size_t from = 0; from < elements; from += window) {
        left.resize(std::min(window, elements - from));
        std::iota(left.begin(), left.end(), static_cast<int>(from));
        while (!left.empty()) {
            auto best = left.begin();
            for (auto it = left.begin(); it != left.end() && wait(*best) < apart; ++it)
                if (wait(*it) > wait(*best)) best = it;
            for (const int v : vertices.subspan(static_cast<size_t>(*best) * per_element, per_element))
                last[static_cast<size_t>(v)] = static_cast<int>(order.size());
            order.push_back(*best);
            left.erase(best);
        }
    }
    return order;
}

}  // namespace drape
