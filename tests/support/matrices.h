// Stiffness and damping as dense matrices, and what they are held to.
#pragma once

#include "cloth/block_matrix.h"
#include "cloth/majorant.h"
#include "support/gradient.h"

namespace drape::test {

// Of a matrix's symmetric part, ascending.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& matrix);

// All 3n rows in the order of the State's columns; zero at pinned vertices.
Eigen::MatrixXd dense(const BlockMatrix& matrix, Eigen::Index vertices);

// A majorant as a matrix of all coordinates.
Eigen::MatrixXd dense(const Majorant& majorant, Eigen::Index vertices);

// -df/dx of a map of all coordinates by central differences of fourth order; zero in rows and columns of
// pinned vertices.
Eigen::MatrixXd minus_jacobian(const std::function<Points(In)>& f, Points x, double h, const Model& model);

}  // namespace drape::test
