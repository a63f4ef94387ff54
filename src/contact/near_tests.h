// What a search rules out four at a time: boxes that do not meet, pieces of cloth that are too far apart.
// No test rules out what is nearer than the reach; some that is barely farther may pass.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace drape {

// Boxes that are to be looked at with each other, their sides in arrays of their own.
class BoxList {
public:
    void clear() { count_ = 0; }
    void add(const double* low, const double* high);
    size_t size() const { return count_; }
    // appends the numbers of every two that meet, the lower first
    void add_meeting(std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);

private:
    std::vector<double> low_[3], high_[3];
    std::vector<std::uint32_t> found_;  // scratch
    size_t count_ = 0;
};

// Four columns of positions: a vertex and a triangle, or both ends of two edges.
struct Candidate {
    int vertex[4];
    int first, second;  // what they are of
};

// Moves those that may be nearer than `reach` to the front, in order; returns how many.
size_t sift_edges(const double* x, double reach, std::span<Candidate> candidates);
size_t sift_triangles(const double* x, double reach, std::span<Candidate> candidates);

}  // namespace drape
