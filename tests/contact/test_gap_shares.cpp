#include <catch2/catch.hpp>

#include "contact/contact.h"
#include "contact/self_contact.h"
#include "support/obstacles.h"
#include "support/touching.h"

using namespace drape;
using namespace drape::test;

namespace {

Fabric two_millimetres() {
    Fabric fabric;
    fabric.thickness = 0.002;
    return fabric;
}

Eigen::VectorXd shares_of(const Setup& setup, In x) {
    const Contact contact(setup.model, setup.obstacles, Vec3(0, -9.81, 0), setup.start, 1);
    return contact.gap_shares(x, 0);
}

}  // namespace

TEST_CASE("the share of a gap is that of the barrier's, and one where nothing touches", "[contact]") {
    const Setup setup = setup_of(raised(square(4), 1), two_millimetres(), {obstacle_of("plane", {})}, 20, 10);
    const Contact contact(setup.model, setup.obstacles, Vec3(0, -9.81, 0), setup.start, 1);
    const ObstacleContact& pair = contact.pairs().front();
    Points x = setup.start.x;
    for (const double share : {0.25, 0.75}) {
        x.row(1).setConstant(pair.offset() + share * pair.barrier().thickness);
        CHECK((contact.gap_shares(x, 0).array() - share).abs().maxCoeff() < 1e-9);
    }
    x.row(1).setConstant(pair.offset() + 1.01 * pair.barrier().thickness);
    CHECK((contact.gap_shares(x, 0).array() == 1).all());
    x(1, 0) = pair.offset() + 0.5 * pair.barrier().thickness;
    const Eigen::VectorXd one_down = contact.gap_shares(x, 0);
    CHECK(one_down[0] == Approx(0.5));
    CHECK(one_down[one_down.size() - 1] == 1);
}

TEST_CASE("the share of a gap between layers is that of their thickness", "[contact]") {
    Setup setup = setup_of(square(4), two_millimetres(), {}, 20, 10);
    const Mesh above = raised(square(3, "one_way", 0.4), 0.0005);
    add_cloth(setup.model, make_cloth(above, two_millimetres()));
    for (Cloth& cloth : setup.model.cloths) cloth.self_contact = true;
    setup.start.x.conservativeResize(3, setup.model.vertices());
    setup.start.x.rightCols(above.vertices()) = above.rest;
    setup.start.v = Points::Zero(3, setup.model.vertices());
    const Eigen::VectorXd shares = shares_of(setup, setup.start.x);
    CHECK((shares.tail(above.vertices()).array() - 0.25).abs().maxCoeff() < 1e-9);
    CHECK(shares[0] == 1);  // a corner of the larger sheet
    CHECK(shares.head(setup.model.vertices() - above.vertices()).minCoeff() == Approx(0.25));

    for (Cloth& cloth : setup.model.cloths) cloth.self_contact = false;
    CHECK((shares_of(setup, setup.start.x).array() == 1).all());
}
