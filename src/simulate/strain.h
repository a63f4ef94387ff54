// How much a cloth is stretched, for the report and the strain picture.
#pragma once

#include "cloth/model.h"

namespace drape {

// Per vertex of the cloth, the strain l/l0 - 1 of its edge that is strained most, with its sign.
Eigen::VectorXf vertex_strain(const Cloth& cloth, In x);

// The largest |l/l0 - 1| of any edge of any cloth.
double largest_strain(const Model& model, In x);

}  // namespace drape
