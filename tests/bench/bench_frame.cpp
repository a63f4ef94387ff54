// What a 720p picture of a cloth over a ball costs, stage by stage: CPU seconds of all threads, the least of
// several frames. The first frame, which compiles what the shaders still need, is not among them.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/timer.h"
#include "io/png.h"
#include "render/palette.h"
#include "render/renderer.h"
#include "support/draped_cloth.h"

namespace drape::bench {

namespace {

constexpr int frames = 7;

// Least CPU seconds by stage, in the order of a frame.
std::vector<StageTime> measure(int side) {
    const Mesh sheet = make_pattern("alternating", {1, 1, side - 1, side - 1});
    DrawnSolid sphere;
    sphere.surface = ball(draped_sphere_radius, 48);
    RenderSettings settings;
    settings.bounds = Eigen::AlignedBox3d(Vec3(-0.5, 0, -0.5), Vec3(0.5, 0.62, 0.5));
    settings.camera = {Vec3(0.9, 0.8, 1.95), Vec3(0, 0.29, 0), 24};
    FrameInput frame;
    frame.cloth = {draped_over_sphere(sheet)};
    Pose pose;
    pose.translation = draped_sphere_centre;
    frame.solid = {pose};
    Renderer renderer(settings, {{&sheet, palette(0)}}, {sphere});
    renderer.draw(frame);

    std::vector<StageTime> least;
    for (int i = 0; i < frames; ++i) {
        std::vector<StageTime> stages;
        const double start = process_cpu_seconds();
        const Image image = renderer.draw(frame, &stages);
        const double drawn = process_cpu_seconds();
        encode_png(image);
        stages.push_back({"whole picture", drawn - start});
        stages.push_back({"PNG", process_cpu_seconds() - drawn});
        if (least.empty()) least = stages;
        for (size_t s = 0; s < stages.size(); ++s)
            least[s].cpu_seconds = std::min(least[s].cpu_seconds, stages[s].cpu_seconds);
    }
    return least;
}

}  // namespace
}  // namespace drape::bench

int main() {
    setenv("LP_NUM_THREADS", "0", 1);  // as drape sets it
    const auto small = drape::bench::measure(129), large = drape::bench::measure(513);
    std::puts("| stage, CPU s | 129 x 129 | 513 x 513 |\n|---|---:|---:|");
    for (size_t s = 0; s < small.size(); ++s)
        std::printf("| %s | %.3f | %.3f |\n", std::string(small[s].name).c_str(), small[s].cpu_seconds,
                    large[s].cpu_seconds);
}
