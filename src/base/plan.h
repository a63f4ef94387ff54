// What a scene uses, and what was left out and why: decided before anything runs, printed by `inspect`,
// carried by report.json.
#pragma once

#include <string>
#include <vector>

namespace drape {

struct Stage {
    std::string name;     // "altitude springs"
    bool used = false;    // false: never built, zero calls
    std::string because;  // "fabric asks for mode blend", "no obstacle in the scene"
};

struct Plan {
    std::vector<Stage> stages;  // in the order the data takes

    void use(std::string name, std::string because) {
        stages.push_back({std::move(name), true, std::move(because)});
    }
    void leave_out(std::string name, std::string because) {
        stages.push_back({std::move(name), false, std::move(because)});
    }
    bool uses(const std::string& name) const {
        for (const Stage& stage : stages)
            if (stage.name == name) return stage.used;
        return false;
    }
};

}  // namespace drape
