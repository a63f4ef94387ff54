#include "contact/near_tests.h"

#include <algorithm>
#include <cmath>

#include "base/padded.h"
#include "base/wide.h"

namespace drape {

namespace {

using lanes::Vertices;

constexpr double slack = 1 + 1e-9;  // far above what rounding moves a squared distance by
constexpr size_t width = 4;

inline __attribute__((always_inline)) Vertices operator-(const Vertices& a, const Vertices& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline __attribute__((always_inline)) Vertices operator+(const Vertices& a, const Vertices& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline __attribute__((always_inline)) Vertices operator*(const Lanes& s, const Vertices& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline __attribute__((always_inline)) Vertices cross(const Vertices& a, const Vertices& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline __attribute__((always_inline)) Lanes within_one(const Lanes& value) {
    const Lanes zero = {}, one = zero + 1;
    const Lanes below = value < one ? value : one;
    return below > zero ? below : zero;
}
inline __attribute__((always_inline)) Lanes least(const Lanes& a, const Lanes& b) {
    return a < b ? a : b;
}

inline __attribute__((always_inline)) Vertices gather(const double* x, const Candidate* candidates,
                                                      int corner) {
    Vertices four;
    for (size_t k = 0; k < width; ++k) {
        const double* at = x + 3 * candidates[k].vertex[corner];
        four.x[k] = at[0];
        four.y[k] = at[1];
        four.z[k] = at[2];
    }
    return four;
}

// As nearest_of_edges (nearest.h): the lines' nearest points, then each held on its edge. Where edges are so
// nearly parallel that rounding chooses the point, any is as near.
inline __attribute__((always_inline)) Lanes edge_distance(const Vertices& a, const Vertices& b,
                                                          const Vertices& c, const Vertices& d) {
    const Vertices u = b - a, v = d - c, w = a - c;
    const Lanes uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
    const Lanes zero = {}, det = uu * vv - uv * uv;
    const Lanes line = within_one((uv * vw - vv * uw) / det);
    const Lanes s = det > zero ? line : zero;
    const Lanes t = (uv * s + vw) / vv, held = within_one(t);
    const Lanes moved = within_one((uv * held - uw) / uu);
    const Vertices way = w + (t == held ? s : moved) * u - held * v;
    return dot(way, way);
}

inline __attribute__((always_inline)) Lanes side_distance(const Vertices& from, const Vertices& side) {
    const Vertices way = from - within_one(dot(from, side) / dot(side, side)) * side;
    return dot(way, way);
}

inline __attribute__((always_inline)) Lanes triangle_distance(const Vertices& p, const Vertices& a,
                                                              const Vertices& b, const Vertices& c) {
    const Vertices ab = b - a, bc = c - b, ca = a - c, up = cross(ab, bc);
    const Vertices ap = p - a, bp = p - b, cp = p - c;
    const Lanes sides = least(least(side_distance(ap, ab), side_distance(bp, bc)), side_distance(cp, ca));
    const Lanes height = dot(up, ap), zero = {};
    const auto above =
        (dot(cross(up, ab), ap) > zero) & (dot(cross(up, bc), bp) > zero) & (dot(cross(up, ca), cp) > zero);
    return above ? least(height * height / dot(up, up), sides) : sides;
}

template <class Distance>
inline __attribute__((always_inline)) size_t sift(double reach, std::span<Candidate> candidates,
                                                  Distance distance) {
    const double most = slack * reach * reach;
    size_t kept = 0;
    Candidate four[width];
    for (size_t i = 0; i < candidates.size(); i += width) {
        const size_t count = std::min(width, candidates.size() - i);
        for (size_t k = 0; k < width; ++k) four[k] = candidates[i + std::min(k, count - 1)];
        const Lanes squared = distance(four);
        for (size_t k = 0; k < count; ++k)
            if (!(squared[k] >= most)) candidates[kept++] = four[k];  // nor what is no number
    }
    return kept;
}

DRAPE_WIDE size_t meet(const double* const* low, const double* const* high, size_t one, size_t from,
                       size_t size, std::uint32_t* found) {
    size_t count = 0;
    const Lanes zero = {};
    const Lanes low_one[3] = {zero + low[0][one], zero + low[1][one], zero + low[2][one]};
    const Lanes high_one[3] = {zero + high[0][one], zero + high[1][one], zero + high[2][one]};
    for (size_t j = from; j < size; j += width) {
        Lanes l, h;
        load(l, low[0] + j);
        load(h, high[0] + j);
        auto meets = (l <= high_one[0]) & (low_one[0] <= h);
        for (int c = 1; c < 3; ++c) {
            load(l, low[c] + j);
            load(h, high[c] + j);
            meets = meets & (l <= high_one[c]) & (low_one[c] <= h);
        }
        for (size_t k = 0; k < width; ++k) {
            found[count] = static_cast<std::uint32_t>(j + k);
            count += meets[k] != 0;
        }
    }
    return count;
}

}  // namespace

DRAPE_WIDE size_t sift_edges(const double* x, double reach, std::span<Candidate> candidates) {
    return sift(
        reach, candidates, [&](const Candidate* four) __attribute__((always_inline)) {
            return edge_distance(gather(x, four, 0), gather(x, four, 1), gather(x, four, 2),
                                 gather(x, four, 3));
        });
}

DRAPE_WIDE size_t sift_triangles(const double* x, double reach, std::span<Candidate> candidates) {
    return sift(
        reach, candidates, [&](const Candidate* four) __attribute__((always_inline)) {
            return triangle_distance(gather(x, four, 0), gather(x, four, 1), gather(x, four, 2),
                                     gather(x, four, 3));
        });
}

void BoxList::add(const double* low, const double* high) {
    for (int c = 0; c < 3; ++c) {
        if (low_[c].size() < count_ + 1 + width) {  // room to read past the last
            low_[c].resize(2 * count_ + 1 + width);
            high_[c].resize(2 * count_ + 1 + width);
        }
        low_[c][count_] = low[c];
        high_[c][count_] = high[c];
    }
    ++count_;
}

void BoxList::add_meeting(std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    const double* low[3] = {low_[0].data(), low_[1].data(), low_[2].data()};
    const double* high[3] = {high_[0].data(), high_[1].data(), high_[2].data()};
    for (size_t k = count_; k < count_ + width && count_ > 0;
         ++k) {  // what is read past the last meets nothing
        low_[0][k] = INFINITY;
        high_[0][k] = -INFINITY;
    }
    found_.resize(count_ + width);
    for (size_t i = 0; i + 1 < count_; ++i) {
        const size_t found = meet(low, high, i, i + 1, count_, found_.data());
        for (size_t k = 0; k < found; ++k) pairs.emplace_back(static_cast<std::uint32_t>(i), found_[k]);
    }
}

}  // namespace drape
