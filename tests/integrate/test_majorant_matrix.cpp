#include "integrate/majorant_matrix.h"

#include <catch2/catch.hpp>

#include "support/motion.h"
#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

// A sheet of every force, two corners held.
struct Sheet {
    Model model = model_of(square(4), full_fabric());
    Sheet() { hold(model, {0, 4}, model.cloths[0].mesh.rest); }
    Dynamics dynamics{model, forces_of(model, {}), nullptr};
    Eigen::VectorXd contact = Eigen::VectorXd::Zero(25);
};

}  // namespace

TEST_CASE("a majorant matrix solves for what its masses, majorants and contact make of a move",
          "[integrate]") {
    Sheet sheet;
    sheet.contact[7] = 300;
    MajorantMatrix matrix(sheet.dynamics);
    for (const double c : {1e-3, 0.1}) {
        matrix.factorise(c, sheet.contact);
        Points move = random_points(25, 1, 4);
        move.col(0).setZero();
        move.col(4).setZero();
        Points force = move * (sheet.model.mass / (c * c) + sheet.contact).asDiagonal();
        for (const double factor : {1.0, 1 / c}) {
            Majorant majorant;
            majorant.weigh(factor);
            for (const ActiveForce& active : sheet.dynamics.forces())
                factor == 1 ? active.force->add_stiffness_majorant(majorant)
                            : active.force->add_damping_majorant(majorant);
            for (const auto& entry : majorant.entries()) {
                force.col(entry.row()) += entry.value() * move.col(entry.col());
                if (entry.row() != entry.col())
                    force.col(entry.col()) += entry.value() * move.col(entry.row());
            }
        }
        CHECK((matrix.solve(force) - move).norm() < 1e-11 * move.norm());
    }
}

TEST_CASE("a majorant matrix is factored again when the step or contact has changed enough", "[integrate]") {
    Sheet sheet;
    MajorantMatrix matrix(sheet.dynamics);
    matrix.factorise(0.01, sheet.contact);
    matrix.factorise(0.01, sheet.contact);
    matrix.follow(0.01, sheet.contact);
    CHECK(matrix.factorisations() == 1);
    sheet.contact[7] = 1e-3;  // far below what the cloth itself has there
    matrix.follow(0.01, sheet.contact);
    CHECK(matrix.factorisations() == 1);
    matrix.factorise(0.01, sheet.contact);
    CHECK(matrix.factorisations() == 2);
    sheet.contact[7] = 1e6;
    matrix.follow(0.01, sheet.contact);
    CHECK(matrix.factorisations() == 3);
    matrix.follow(0.02, sheet.contact);
    CHECK(matrix.factorisations() == 4);
}
