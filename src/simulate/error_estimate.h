// How far two passes of one scene are apart, and what that says about the error of the better one.
#pragma once

#include <array>

#include "cloth/model.h"

namespace drape {

struct ErrorNorms {
    double rms = 0;  // root of the mean squared distance over all vertices [m]
    double max = 0;  // the largest distance [m]
};

ErrorNorms distance_between(In a, In b);

// Richardson: two passes of order p with errors C H^p and C h^p are |C| |H^p - h^p| apart. What share of that
// distance is the error of the pass with `own` steps, when the other took `other` steps: 1 / |r^p - 1|, r =
// own / other, whichever is the finer. Where the scene spoils the order (contact comes and goes, folds
// buckle) a lower p claims more error.
double error_share(double own, double other, double order);

// Richardson's rule holds while passes run side by side. Where folds fall differently in one, they part until
// their distance is that of any two runs, and no share of it is the step's error: each is then about that
// distance from the truth. So once the rule claims more than the cloth's mean edge `edge`, twice the distance
// is stated, if that is less. What to multiply a distance (RMS) by.
double stated_share(double distance, double share, double edge);

// Mean rest length of all edges of all cloths [m].
double mean_edge(const Model& model);

// The order p that three passes with numbers of steps n0 < n1 < n2 show: their distances' ratio is (h0^p -
// h1^p) / (h1^p - h2^p). Kept between `least` and `most`.
double observed_order(const std::array<double, 3>& steps, double first_distance, double second_distance,
                      double least, double most);

// What summing `steps` steps in double precision alone may have cost [m]: no estimate claims less.
double round_off(In x, double steps);

// Per vertex, the distance times `share` [m]: for the error picture.
Eigen::VectorXf vertex_errors(In a, In b, double share);

}  // namespace drape
