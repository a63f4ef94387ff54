#include "support/membranes.h"

#include "base/rigid_motion.h"

namespace drape::test {

Fabric membrane_fabric(MembraneKind kind, double modulus, double poisson) {
    Fabric fabric;
    fabric.density = 0.2;
    fabric.stretch_model = StretchModel::membrane;
    fabric.stretch = modulus;
    fabric.membrane = kind;
    fabric.membrane_poisson = poisson;
    return fabric;
}

std::vector<NamedPose> membrane_poses(const Mesh& mesh) {
    const Mat3 turn = rotation_from_degrees({30, -50, 70});
    const auto pose = [&](const Mat3& strain) -> Points {
        return turn * (strain * mesh.rest + random_points(mesh.vertices(), 0.01, 5));
    };
    const auto along = [](double x, double z) -> Mat3 { return Vec3(x, 1, z).asDiagonal(); };
    Mat3 sheared = Mat3::Identity();
    sheared(0, 2) = 0.7;
    std::vector<NamedPose> poses{{"stretched", pose(along(1.5, 1.2))},
                                 {"pulled one way", pose(along(1.8, 0.9))},
                                 {"squeezed", pose(along(0.4, 0.7))},
                                 {"sheared", pose(sheared)}};
    // the vertex nearest the middle, moved far past its neighbours
    Points inverted = mesh.rest + random_points(mesh.vertices(), 0.01, 6);
    Eigen::Index middle = 0;
    mesh.rest.colwise().squaredNorm().minCoeff(&middle);
    inverted.col(middle) += Vec3(0.5, 0, 0.1);
    poses.push_back({"inverted", turn * inverted});
    return poses;
}

}  // namespace drape::test
