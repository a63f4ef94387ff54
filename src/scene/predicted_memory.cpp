#include "scene/predicted_memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "mesh/pattern.h"
#include "scene/builder.h"

namespace drape {

namespace {

constexpr double of_pass = 1600, of_build = 900;         // a vertex [bytes]
constexpr double of_program = 12e6, of_renderer = 95e6;  // [bytes]
// of a picture's pixel: samples, the picture and its PNG
constexpr double of_pixel = 70;
constexpr double of_position = 3 * sizeof(double);

// "MemAvailable:   123456 kB" [bytes]
double available_memory() {
    std::ifstream info("/proc/meminfo");
    std::string key, rest;
    for (double kilobytes = 0; info >> key >> kilobytes; std::getline(info, rest))
        if (key == "MemAvailable:") return 1024 * kilobytes;
    return INFINITY;
}

double most_of(__rlimit_resource what) {
    rlimit limit{};
    if (getrlimit(what, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return INFINITY;
    return static_cast<double>(limit.rlim_cur);
}

}  // namespace

double predicted_memory(const SceneDescription& scene, const RunExtent& extent) {
    double vertices = 0;
    for (const ClothDescription& cloth : scene.cloths)
        if (cloth.mesh.empty()) vertices += about_vertices(cloth.pattern, pattern_size_of(scene, cloth));
    const double passes = extent.two_passes ? 2 : 1;
    double bytes = of_program + vertices * (of_build + passes * of_pass);
    // a tolerance is met by passes that are kept whole until they are compared
    if (scene.accuracy.tolerance) bytes += 2.0 * extent.frames * vertices * of_position;
    const double pixels = double(scene.look.size[0]) * scene.look.size[1];
    return bytes + extent.drawing * (of_renderer + pixels * of_pixel);
}

double free_memory() {
    return std::min({available_memory(), most_of(RLIMIT_AS), most_of(RLIMIT_DATA)});
}

}  // namespace drape
