#include "contact/self_search.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

namespace {

using Key = std::array<int, 5>;

std::set<Key> keys_of(const std::vector<SelfPair>& pairs) {
    std::set<Key> keys;
    for (const SelfPair& pair : pairs)
        keys.insert({pair.edges, pair.vertex[0], pair.vertex[1], pair.vertex[2], pair.vertex[3]});
    CHECK(keys.size() == pairs.size());
    return keys;
}

// Two cloths that meet each other; the second comes from another mesh.
Model two_sheets(int divisions) {
    Model model = model_of(square(divisions), bare_springs(100));
    add_cloth(model, make_cloth(square(divisions + 1, "one_way"), bare_springs(100)));
    for (Cloth& cloth : model.cloths) cloth.self_contact = true;
    return model;
}

std::set<Key> brute_force(const Model& model, const Points& x, double reach, double excluded) {
    std::set<Key> keys;
    struct Piece {
        std::vector<int> vertex;
        int cloth;
    };
    std::vector<Piece> vertices, edges, faces;
    Points rest(3, model.vertices());
    for (int c = 0; c < static_cast<int>(model.cloths.size()); ++c) {
        const Cloth& cloth = model.cloths[static_cast<size_t>(c)];
        rest.middleCols(cloth.first, cloth.vertices()) = cloth.mesh.rest;
        for (int v = 0; v < cloth.vertices(); ++v) vertices.push_back({{cloth.first + v}, c});
        for (const Edge& edge : cloth.topology.edges)
            edges.push_back({{cloth.first + edge.vertex[0], cloth.first + edge.vertex[1]}, c});
        for (const auto& face : cloth.mesh.faces.colwise()) {
            Piece piece{{cloth.first + face[0], cloth.first + face[1], cloth.first + face[2]}, c};
            std::sort(piece.vertex.begin(), piece.vertex.end());
            faces.push_back(piece);
        }
    }
    const auto look = [&](const Piece& one, const Piece& two) {
        std::vector<int> all = one.vertex;
        all.insert(all.end(), two.vertex.begin(), two.vertex.end());
        if (std::set<int>(all.begin(), all.end()).size() < 4) return;
        SelfPair pair{{all[0], all[1], all[2], all[3]}, 0, one.vertex.size() == 2, 1, 1};
        if (nearest_of(pair, points_of(pair, x.data())).distance >= reach) return;
        if (one.cloth == two.cloth && nearest_of(pair, points_of(pair, rest.data())).distance < excluded)
            return;
        keys.insert({pair.edges, all[0], all[1], all[2], all[3]});
    };
    for (const Piece& vertex : vertices)
        for (const Piece& face : faces) look(vertex, face);
    for (size_t i = 0; i < edges.size(); ++i)
        for (size_t j = i + 1; j < edges.size(); ++j) look(edges[i], edges[j]);
    return keys;
}

}  // namespace

TEST_CASE("the search finds just those pairs that looking at all of them finds", "[contact]") {
    const Model model = two_sheets(4);
    SelfSearch search(model, {0.02, 0.02, 0.02, 0.02});
    std::vector<SelfPair> pairs;
    for (unsigned seed = 0; seed < 6; ++seed) {
        // a crumpled heap, and one with a corner pulled far out
        Points x = random_points(model.vertices(), seed < 3 ? 0.5 : 0.2, seed);
        if (seed == 5) x.col(0) = Vec3(40, 3, -70);
        for (const double reach : {0.01, 0.1}) {
            search.find(x, reach, pairs);
            CHECK(keys_of(pairs) == brute_force(model, x, reach, 0.04));
        }
    }
}

TEST_CASE("neighbours at rest are no pairs however fine the mesh", "[contact]") {
    Model model = model_of(square(20), bare_springs(100));
    model.cloths[0].self_contact = true;
    std::vector<SelfPair> pairs;
    SelfSearch(model, {0.1}).find(model.cloths[0].mesh.rest, 0.1, pairs);
    CHECK(pairs.empty());
    // a mesh coarser than its thickness has the pairs across an edge
    SelfSearch(model, {0.001}).find(model.cloths[0].mesh.rest, 0.1, pairs);
    CHECK_FALSE(pairs.empty());
}

TEST_CASE("pairs come in the same order whatever the reach", "[contact]") {
    const Model model = two_sheets(3);
    SelfSearch search(model, {0.02, 0.02, 0.02, 0.02});
    const Points x = random_points(model.vertices(), 0.3, 8);
    std::vector<SelfPair> few, many;
    search.find(x, 0.05, few);
    search.find(x, 0.2, many);
    REQUIRE(few.size() > 10);
    auto at = many.begin();
    for (const SelfPair& pair : few) {
        at = std::find_if(at, many.end(), [&](const SelfPair& other) {
            return pair.edges == other.edges && std::equal(pair.vertex, pair.vertex + 4, other.vertex);
        });
        REQUIRE(at != many.end());
    }
}

TEST_CASE("only cloths that meet cloth are searched and motion that ran away finds nothing", "[contact]") {
    Model model = two_sheets(3);
    model.cloths[1].self_contact = false;
    SelfSearch search(model, {0.02, 0.02, 0.02, 0.02});
    Points x = random_points(model.vertices(), 0.2, 9);
    std::vector<SelfPair> pairs;
    search.find(x, 0.1, pairs);
    CHECK_FALSE(pairs.empty());
    for (const SelfPair& pair : pairs) CHECK(*std::max_element(pair.vertex, pair.vertex + 4) < 16);
    x(0, 3) = NAN;
    search.find(x, 0.1, pairs);
    CHECK(pairs.empty());
}
