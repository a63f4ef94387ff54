// Prints what the sweeps make of a crumpled sheet, bit for bit: built for several vector widths
// (CMakeLists.txt) and compared by test_sweep_bits.cpp.
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/padded.h"
#include "force/blend_sweep.h"
#include "force/edge_sweep.h"
#include "force/membrane_sweep.h"

using namespace drape;

namespace {

constexpr int side = 7;

PaddedPoints crumpled(double phase) {
    PaddedPoints points(4, side * side);
    for (int i = 0; i < points.cols(); ++i)
        points.col(i) << i % side + 0.3 * std::sin(7 * i + phase), std::cos(3 * i + phase),
            i / side + 0.2 * std::sin(5 * i - phase), 0;
    return points;
}

void print(const char* name, double heat, const PaddedPoints& f) {
    std::printf("%s heat %a\n", name, heat);
    for (int i = 0; i < f.cols(); ++i) std::printf("%a %a %a\n", f(0, i), f(1, i), f(2, i));
}

}  // namespace

int main() {
    std::vector<Spring> springs;
    std::vector<int> corner[3];
    for (int j = 0; j + 1 < side; ++j) {
        for (int i = 0; i + 1 < side; ++i) {
            const int a = j * side + i, b = a + 1, c = b + side;
            springs.push_back({a, b, 0.9, 30.0 + i, 0.1});
            springs.push_back({a, c, 1.3, 20.0 + j, 0.2});
            corner[0].push_back(a);
            corner[1].push_back(b);
            corner[2].push_back(c);
        }
    }
    const std::vector<double> ones(springs.size(), 1.0), weights(springs.size(), 3.7),
        damping(springs.size(), 0.1);
    const PaddedPoints x = crumpled(0), v = crumpled(1);
    const PaddedPoints none = PaddedPoints::Zero(4, x.cols());

    const EdgeSweep edges(springs, 0);
    PaddedPoints f = none;
    edges.pull(x, f);
    print("edges", 0, f);
    f = none;
    const double edge_heat = edges.pull_damped(x, v, f);
    print("damped edges", edge_heat, f);

    const BlendSweep blend({{corner[0].data(), corner[1].data(), corner[2].data()},
                            {ones.data(), ones.data(), ones.data()},
                            ones.data(),
                            weights.data(),
                            damping.data()},
                           static_cast<int>(corner[0].size()));
    f = none;
    blend.push(x, f);
    print("blend", 0, f);
    f = none;
    const double blend_heat = blend.push_damped(x, v, f);
    print("damped blend", blend_heat, f);

    std::vector<MembraneElement> elements;
    for (size_t i = 0; i < corner[0].size(); ++i) {
        MembraneElement element;
        element.corner = {corner[0][i], corner[1][i], corner[2][i]};
        element.area = 0.5;
        element.squared << 2, 1, 1;
        element.trace << 0.1, 0.9, 1.1;
        element.coupling << 3, 0.5, 0.4, 0.5, 4, -0.3, 0.4, -0.3, 5;
        element.relaxation = 0.07;
        elements.push_back(element);
    }
    for (const MembraneKind kind : {MembraneKind::stvk, MembraneKind::neo_hookean}) {
        const MembraneSweep membrane(elements, kind, {3, 1, 4});
        f = none;
        membrane.push(x, f);
        print("membrane", 0, f);
        f = none;
        const double heat = membrane.push_damped(x, v, f);
        print("damped membrane", heat, f);
    }
}
