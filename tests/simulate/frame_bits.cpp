// Prints the bits of small runs of every method over every kind of force: built for several vector widths
// (CMakeLists.txt) and compared by test_frame_bits.cpp.
#include <cstdio>

#include "support/setups.h"

using namespace drape;
using namespace drape::test;

namespace {

void print_frames(const char* name, Setup setup) {
    setup.frames = 2;
    for (const Method& method : methods()) {
        setup.method = method.name;
        setup.step.reset();
        if (method.is_implicit()) setup.step = 1 / 80.0;
        try {
            Simulation simulation(setup);
            while (simulation.frame() < simulation.frames()) {
                const FrameReport frame = simulation.advance();
                std::printf("%s %s %s %s heat %a\n", name, setup.method.c_str(), frame.hash.c_str(),
                            frame.trouble.c_str(), simulation.flow().dissipated);
            }
        } catch (const Error& error) {
            std::printf("%s %s is not for this scene\n", name, setup.method.c_str());
        }
    }
}

Fabric membrane(MembraneKind kind, double damping) {
    Fabric fabric = full_fabric();
    fabric.stretch_model = StretchModel::membrane;
    fabric.altitude = AltitudeMode::none;
    fabric.membrane = kind;
    fabric.damping = damping;
    return fabric;
}

}  // namespace

int main() {
    print_frames("springs", swatch(7, 300));
    print_frames("flag", flag(7));
    print_frames("drop", ball_drop(7));
    Fabric undamped = full_fabric();
    undamped.damping = 0;
    print_frames("blend", scene_of(square(7), undamped, {0}));
    for (const double damping : {0.0, 0.05}) {
        print_frames("stvk", scene_of(square(7), membrane(MembraneKind::stvk, damping), {0}));
        print_frames("neo_hookean", scene_of(square(7), membrane(MembraneKind::neo_hookean, damping), {0}));
    }
}
