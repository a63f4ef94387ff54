#include "base/padded.h"

#include "base/wide.h"

namespace drape {

namespace {

DRAPE_WIDE void spread_out(const double* from, Eigen::Index points, double* to) {
    // a load of four takes the next vertex's x along; the last vertex has no next
    for (Eigen::Index i = 0; i + 1 < points; ++i) {
        Lanes point;
        load(point, from + 3 * i);
        point[3] = 0;
        store(point, to + 4 * i);
    }
    if (points == 0) return;
    const double* last = from + 3 * (points - 1);
    store(Lanes{last[0], last[1], last[2], 0}, to + 4 * (points - 1));
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
