#include "simulate/twin.h"

#include <random>

namespace drape {

State moved_a_little(const Model& model, State start) {
    std::mt19937 random(1);
    for (Eigen::Index i = 0; i < start.x.cols(); ++i) {
        Vec3 way;
        for (double& c : way) c = double(random()) / double(std::mt19937::max()) - 0.5;
        if (model.inverse_mass[i] > 0) start.x.col(i) += twin_offset * way.normalized();
    }
    return start;
}

}  // namespace drape
