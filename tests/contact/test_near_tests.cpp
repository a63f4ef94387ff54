#include "contact/near_tests.h"

#include <catch2/catch.hpp>

#include "contact/nearest.h"
#include "support/cloths.h"

using namespace drape;
using namespace drape::test;

namespace {

// As candidates, four columns each.
std::vector<Candidate> in_fours(const Points& x) {
    std::vector<Candidate> candidates;
    for (int i = 0; i + 3 < x.cols(); i += 4) candidates.push_back({{i, i + 1, i + 2, i + 3}, i, 0});
    return candidates;
}

// What a sift keeps is what is near: all of it, and hardly more.
void check_sifted(const Points& x, double reach, bool edges) {
    std::vector<Candidate> all = in_fours(x), sifted = all;
    sifted.resize(edges ? sift_edges(x.data(), reach, sifted) : sift_triangles(x.data(), reach, sifted));
    auto kept = sifted.begin();
    for (const Candidate& one : all) {
        const Vec3 a = x.col(one.vertex[0]), b = x.col(one.vertex[1]), c = x.col(one.vertex[2]),
                   d = x.col(one.vertex[3]);
        const double distance =
            (edges ? nearest_of_edges(a, b, c, d) : nearest_to_triangle(a, b, c, d)).distance;
        const bool is_kept = kept != sifted.end() && kept->first == one.first;
        CAPTURE(one.first, distance);
        if (distance < reach) CHECK(is_kept);
        if (distance > reach * (1 + 1e-8)) CHECK_FALSE(is_kept);
        if (is_kept) ++kept;
    }
    CHECK(kept == sifted.end());
}

}  // namespace

TEST_CASE("sifting keeps what is near and nothing else", "[contact]") {
    const Points x = random_points(4 * 501, 1, 5);
    for (const double reach : {0.05, 0.3, 1.0}) {
        check_sifted(x, reach, true);
        check_sifted(x, reach, false);
    }
}

TEST_CASE("sifting keeps what is near of parallel edges and flat triangles", "[contact]") {
    Points x = random_points(4 * 100, 1, 6);
    for (int i = 0; i < 400; i += 4) {
        const Vec3 along = x.col(i + 1) - x.col(i);
        x.col(i + 3) = x.col(i + 2) + (i % 8 == 0 ? 1 : 1 + 1e-9 * i) * along;
    }
    check_sifted(x, 0.4, true);
    x.row(1).setZero();
    check_sifted(x, 0.2, false);
}

TEST_CASE("sifting takes edges of no length and leaves what is no number to those who look closer",
          "[contact]") {
    Points x = random_points(12, 1, 7);
    x.col(0) = x.col(1);
    check_sifted(x, 0.7, true);
    x(0, 4) = NAN;
    std::vector<Candidate> candidates{in_fours(x)[1]};
    CHECK(sift_edges(x.data(), 1e-3, candidates) == 1);
    CHECK(sift_triangles(x.data(), 1e-3, candidates) == 1);
}

TEST_CASE("boxes that meet are found, each two once", "[contact]") {
    for (const int count : {0, 1, 2, 5, 40}) {
        const Points low = random_points(std::max(count, 1), 1, 8),
                     size = random_points(std::max(count, 1), 0.3, 9);
        BoxList boxes;
        boxes.add(low.data(), low.data());  // what was there before
        boxes.clear();
        std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, found;
        std::vector<Vec3> high;
        for (int i = 0; i < count; ++i) {
            high.push_back(low.col(i) + size.col(i).cwiseAbs());
            boxes.add(low.col(i).data(), high.back().data());
            for (int j = 0; j < i; ++j)
                if ((low.col(j).array() <= high[size_t(i)].array()).all() &&
                    (low.col(i).array() <= high[size_t(j)].array()).all())
                    expected.emplace_back(j, i);
        }
        boxes.add_meeting(found);
        std::sort(expected.begin(), expected.end());
        CHECK(found == expected);
        CHECK(boxes.size() == static_cast<size_t>(count));
    }
}
