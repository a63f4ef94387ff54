// Small pictures of every demo scene that later versions are held to. They lie in renders/reference as
// frame_SCENE_1.png and frame_SCENE_2.png, with the limits that they are judged by (compare.toml) and what
// made them (made.json).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/picture_maker.h"
#include "base/image.h"

namespace drape::test {

constexpr int width = 320, height = 180;  // of the pictures

// A demo scene as its references have it: two frames, on so coarse a mesh that they cost a second or two.
struct Reference {
    std::string scene;
    std::vector<std::string> set;  // KEY=VALUE over the scene file
};

std::span<const Reference> references();

std::string reference_folder();

// The arguments of the program that draw the same frames, as frame_0001.png and frame_0002.png.
std::vector<std::string> arguments_of(const Reference& reference);

// A frame, ready to be drawn.
struct Moment {
    std::string name;  // of its reference, "frame_flag_1.png"
    DrawnScene drawn;
    FrameInput input;
};

// Simulates the scene; what `visit` gets of each frame holds while it is called.
void visit_moments(const Reference& reference, const std::function<void(const Moment&)>& visit);

// `renderer`, where given, is told who drew.
Image picture_of(const Moment& moment, std::string* renderer = nullptr);

}  // namespace drape::test
