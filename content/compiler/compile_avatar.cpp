#include "content/compiler/compile_avatar.h"

#include "content/avatar/avatar.h"
#include "content/content_error.h"
#include "content/motion/compile_motion.h"

namespace docent {

void plan_avatar_stages(Progress& progress) {
  progress.plan("motion", 40);
  progress.plan("avatar", 15);
}

CompiledAvatar compile_avatar(const std::vector<std::filesystem::path>& clip_folders, unsigned jobs,
                              Progress& progress) {
  CompiledAvatar compiled;
  try {
    {
      const auto stage = progress.start("motion");
      compiled.motion =
          compile_motion(clip_folders, {.transitions = {}, .jobs = jobs}, compiled.problems);
    }
    const auto stage = progress.start("avatar");
    compiled.mesh = make_avatar(compiled.motion.skeleton);
  } catch (const ContentError& error) {
    compiled.problems.push_back(to_diagnostic(error));
  }
  return compiled;
}

}  // namespace docent
