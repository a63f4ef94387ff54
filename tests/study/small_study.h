// A study of a very small scene, run once for all tests that look at it.
#pragma once

#include <span>

#include "study/study.h"
#include "support/setups.h"

namespace drape::test {

inline Setup small_scene() {
    Setup setup = swatch(4, 200);
    setup.frames = 3;
    return setup;
}

inline std::vector<const Method*> every_method() {
    std::vector<const Method*> all;
    for (const Method& method : methods()) all.push_back(&method);
    return all;
}

inline const Study& small_study() {
    static const Study study = [] {
        StudyOptions options;
        options.repeats = 2;
        options.budget = 3;
        options.methods = every_method();
        Study made = run_study(small_scene(), options, {});
        made.scene = "a <small> & 'plain' \"scene\"";
        return made;
    }();
    return study;
}

}  // namespace drape::test
