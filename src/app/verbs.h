// The program's verbs, one file each. Each returns the exit code, or throws Error.
#pragma once

#include <string>
#include <string_view>

#include "app/options.h"
#include "base/error.h"

namespace drape {

Exit run_scene(const RunOptions& options);                                         // render, simulate
Exit inspect(const std::string& path, const std::vector<std::string>& overrides);  // a scene or a mesh
Exit study_scene(const StudyRequest& request);
Exit map_stability(const StabilityRequest& request);
Exit run_lab(const LabRequest& request);
void list_experiments(void (*row)(std::string_view name, std::string_view says));  // of the lab
Exit compare_results(const CompareRequest& request);
Exit make_video(const VideoRequest& request);
Exit make_gallery(const GalleryRequest& request);
Exit write_pattern(const PatternOptions& options);
Exit list_kinds(const std::string& kind);  // "" = all

}  // namespace drape
