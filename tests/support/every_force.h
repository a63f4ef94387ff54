// Every force in the table, on every fabric that changes what one does.
#pragma once

#include "force/force.h"
#include "support/cloths.h"

namespace drape::test {

struct Case {
    std::string name;
    std::unique_ptr<Force> force;
    bool internal;  // pushes the cloth only against itself
};

std::vector<Fabric> every_fabric();

std::vector<Case> every_force(const Cloth& cloth);

}  // namespace drape::test
