#include "app/frame_name.h"

#include <cstdio>

namespace drape {

std::string frame_name(int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "/frame_%04d.png", frame);
    return name;
}

}  // namespace drape
