#include "base/padded.h"

#include "base/wide.h"

namespace drape {

namespace {

DRAPE_WIDE void spread_out(const double* from, Eigen::Index points, double* to) {
    for (Eigen::Index i = 0; i < points; ++i) {
        const Lanes point = {from[3 * i], from[3 * i + 1], from[3 * i + 2], 0};
        store(point, to + 4 * i);
    }
}

DRAPE_WIDE void close_up(const double* from, Eigen::Index points, double* to) {
    for (Eigen::Index i = 0; i < points; ++i)
        for (int k = 0; k < 3; ++k) to[3 * i + k] = from[4 * i + k];
}

}  // namespace

void pad(In points, PaddedPoints& padded) {
    padded.resize(4, points.cols());
    spread_out(points.data(), points.cols(), padded.data());
}

void unpad(const PaddedPoints& padded, Points& points) {
    points.resize(3, padded.cols());
    close_up(padded.data(), padded.cols(), points.data());
}

}  // namespace drape
