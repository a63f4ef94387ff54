// Which bending a fabric asks for.
#include "force/bend_hinge.h"
#include "force/bend_plate.h"
#include "force/edge_spring.h"
#include "force/kinds.h"

namespace drape {

MadeForce make_bending(const Cloth& cloth, const Surroundings&) {
    if (cloth.fabric.bending == 0) return {nullptr, "fabric has no bending stiffness"};
    switch (cloth.fabric.bending_kind) {
        case BendingKind::none:
            return {nullptr, "fabric has no bending"};
        case BendingKind::plate:
            return {std::make_unique<BendPlate>(cloth), "bending kind plate"};
        case BendingKind::hinge:
            return {std::make_unique<BendHinge>(cloth), "bending kind hinge"};
        case BendingKind::spring:
            return {std::make_unique<EdgeSprings>(cloth.network.bends, cloth.first), "bending kind spring"};
    }
    return {};
}

}  // namespace drape
