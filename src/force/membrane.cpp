#include "force/membrane.h"

#include "base/assert.h"
#include "force/kinds.h"
#include "force/membrane_projection.h"

namespace drape {

namespace {

std::vector<MembraneElement> elements_of(const Cloth& cloth) {
    std::vector<MembraneElement> elements;
    for (int f = 0; f < cloth.mesh.triangles(); ++f) elements.push_back(membrane_element(cloth, f));
    return elements;
}

// grad Q_k / 2 of the three edges, one a column
Eigen::Matrix<double, 9, 3> gradients_of(const MembranePose& pose) {
    Eigen::Matrix<double, 9, 3> gradients = Eigen::Matrix<double, 9, 3>::Zero();
    for (int k = 0; k < 3; ++k) {
        gradients.block<3, 1>(3 * ((k + 1) % 3), k) = -pose.edge[static_cast<size_t>(k)];
        gradients.block<3, 1>(3 * ((k + 2) % 3), k) = pose.edge[static_cast<size_t>(k)];
    }
    return gradients;
}

}  // namespace

Membrane::Membrane(const Cloth& cloth)
    : kind_(cloth.fabric.membrane),
      moduli_(moduli_of(cloth.fabric)),
      damped_(cloth.fabric.damping > 0),
      elements_(elements_of(cloth)),
      sweep_(elements_, kind_, moduli_) {
    DRAPE_ASSERT(cloth.fabric.stretch_model == StretchModel::membrane);
}

Membrane::~Membrane() = default;

MembraneResponse Membrane::response_of(const MembraneElement& element, const MembranePose& pose) const {
    return kind_ == MembraneKind::stvk ? stvk_response(element, pose)
                                       : neo_hookean_response(element, pose, moduli_);
}

double Membrane::energy(In x) const {
    double energy = 0;
    for (const MembraneElement& element : elements_)
        energy += response_of(element, membrane_pose(element, x)).energy;
    return energy;
}

void Membrane::add_padded_conservative(const PaddedPoints& x, PaddedPoints& f) const {
    sweep_.push(x, f);
}

Power Membrane::add_padded(const PaddedPoints& x, const PaddedPoints& v, PaddedPoints& f) const {
    return {sweep_.push_damped(x, v, f), 0};
}

void Membrane::add_couplings(Couplings& couplings) const {
    for (const MembraneElement& element : elements_) couplings.couple(element.corner);
}

// E(Q) has the Hessian sum E_k hess Q_k + sum E_kj grad Q_k (grad Q_j)', with E_k = t_k / 2,
// E_kj = 1/2 dt_k/dQ_j and Q_k = |x_(k+2) - x_(k+1)|^2.
void Membrane::add_stiffness(In x, BlockMatrix& k) const {
    for (const MembraneElement& element : elements_) {
        const MembranePose pose = membrane_pose(element, x);
        const MembraneResponse response = response_of(element, pose);
        const auto gradients = gradients_of(pose);
        BlockMatrix::Element stiffness = gradients * (2 * response.change) * gradients.transpose();
        for (int i = 0; i < 3; ++i) {
            const int a = 3 * ((i + 1) % 3), b = 3 * ((i + 2) % 3);
            const Mat3 tension = response.tension[i] * Mat3::Identity();
            stiffness.block<3, 3>(a, a) += tension;
            stiffness.block<3, 3>(b, b) += tension;
            stiffness.block<3, 3>(a, b) -= tension;
            stiffness.block<3, 3>(b, a) -= tension;
        }
        k.add_element(element.corner, stiffness);
    }
}

void Membrane::add_damping(In x, In, double, BlockMatrix& b) const {
    if (!damped_) return;
    for (const MembraneElement& element : elements_) {
        const auto gradients = gradients_of(membrane_pose(element, x));
        b.add_element(element.corner,
                      gradients * (2 * element.relaxation * element.coupling) * gradients.transpose());
    }
}

void Membrane::project(WeightedPoints& x, const WeightedPoints& before, double h) {
    if (!projection_) projection_ = std::make_unique<MembraneProjection>(elements_, kind_, moduli_);
    projection_->sweep(x, before, h);
}

MadeForce make_membrane(const Cloth& cloth, const Surroundings&) {
    switch (cloth.fabric.membrane) {
        case MembraneKind::none:
            return {nullptr, "fabric has springs, no finite elements"};
        case MembraneKind::stvk:
            return {std::make_unique<Membrane>(cloth), "St. Venant-Kirchhoff triangles"};
        case MembraneKind::neo_hookean:
            return {std::make_unique<Membrane>(cloth), "stable neo-Hookean triangles"};
    }
    return {};
}

}  // namespace drape
