// Where contact works, and how hard: for pictures.
#include <algorithm>

#include "contact/contact.h"
#include "contact/self_contact.h"

namespace drape {

Eigen::VectorXd Contact::gap_shares(In x, double time) const {
    Eigen::VectorXd shares = Eigen::VectorXd::Ones(x.cols());
    for (const ObstacleContact& pair : pairs_) pair.lower_gap_shares(x, time, shares);
    if (self_) self_->lower_gap_shares(x, time, shares);
    return shares;
}

void ObstacleContact::lower_gap_shares(In x, double time, Eigen::VectorXd& shares) const {
    const Pose pose = obstacle_.motion.at(time).pose;
    for (const ContactPoint& point : points_) {
        const double gap = sample(pose, value_at(point, x.data())).distance - offset_;
        for (int k = 0; k < point.corners; ++k) {
            double& share = shares[point.vertex[k]];
            share = std::min(share, gap / barrier_.thickness);
        }
    }
}

void SelfContact::lower_gap_shares(In cloth, double time, Eigen::VectorXd& shares) {
    const auto x = surfaces_.positions(cloth, time);
    std::vector<SelfPair> pairs;
    search_.find(x, thickness_, pairs);
    for (const SelfPair& pair : pairs) {
        const double gap = nearest_of(pair, points_of(pair, x.data())).distance;
        const double share = gap / layers(pair).barrier.thickness;
        for (const int v : pair.vertex)
            if (v < surfaces_.columns()) shares[v] = std::min(shares[v], share);
    }
}

}  // namespace drape
