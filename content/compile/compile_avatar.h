#pragma once

#include <filesystem>
#include <vector>

#include "content/compile/progress.h"
#include "content/motion/enrich.h"
#include "runtime/model/diagnostic.h"
#include "runtime/model/motion/motion_graph.h"
#include "runtime/model/motion/skinned_mesh.h"

namespace docent::compile {

/// What walks: the motion graph of some clips and a body made to measure for their skeleton.
struct CompiledAvatar {
  MotionGraph motion;
  SkinnedMesh mesh;
  std::vector<Diagnostic> problems;
};

/// What an avatar is made of.
struct AvatarSources {
  std::vector<std::filesystem::path> clip_folders;
  std::filesystem::path model;  ///< The museum's own character; empty where ours guide.
  bool only_motion = false;     ///< No body, no foresight: enough to know where hands get to.
};

void plan_avatar_stages(const AvatarSources& sources, Progress& progress);

/// Compiles the clips of the folders, for the museum's own character where it has one. What is
/// wrong with them is in `problems`; where any of it is an error, the rest is empty.
CompiledAvatar compile_avatar(const AvatarSources& sources, motion::offline::Enrichment enrichment,
                              unsigned jobs, Progress& progress);

}  // namespace docent::compile
