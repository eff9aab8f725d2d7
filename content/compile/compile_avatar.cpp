#include "content/compile/compile_avatar.h"

#include <optional>

#include "content/avatar/avatar.h"
#include "content/compile/own_figure.h"
#include "content/content_error.h"
#include "content/motion/compile_motion.h"
#include "content/parallel.h"
#include "runtime/motion/make_foresight.h"

namespace docent::compile {
namespace {

/// Nothing where the clips cannot walk; the walk says why.
Foresight foresee(const MotionGraph& motion, unsigned jobs) {
  const Result<motion::WalkGraph> graph = motion::make_walk_graph(motion);
  if (!graph) return {};
  Foresight foresight = motion::begin_foresight(*graph);
  content::for_each_index(bend_axis.count, jobs,
                          [&](std::size_t bend) { motion::add_bend(*graph, bend, foresight); });
  return foresight;
}

}  // namespace

void plan_avatar_stages(const AvatarSources& sources, Progress& progress) {
  progress.plan("motion", 40);
  if (sources.only_motion) return;
  progress.plan("foresight", 40);
  progress.plan("avatar", 15);
}

CompiledAvatar compile_avatar(const AvatarSources& sources, motion::offline::Enrichment enrichment,
                              unsigned jobs, Progress& progress) {
  CompiledAvatar compiled;
  try {
    std::optional<OwnFigure> own;
    if (!sources.model.empty()) own.emplace(sources.model, compiled.problems);
    {
      const auto stage = progress.start("motion");
      motion::offline::MotionOptions options{
          .transitions = {}, .enrichment = enrichment, .jobs = jobs};
      if (own)
        options.give_to_other = [&](Skeleton& skeleton, auto& clips) {
          return own->take(skeleton, clips, jobs);
        };
      compiled.motion =
          motion::offline::compile_motion(sources.clip_folders, options, compiled.problems);
    }
    if (sources.only_motion) return compiled;
    {
      const auto stage = progress.start("foresight");
      compiled.motion.foresight = foresee(compiled.motion, jobs);
    }
    const auto stage = progress.start("avatar");
    compiled.mesh = own ? own->among_others(compiled.motion.skeleton, jobs)
                        : avatar::make_avatars(compiled.motion.skeleton, jobs);
  } catch (const content::ContentError& error) {
    compiled.problems.push_back(content::to_diagnostic(error));
  }
  return compiled;
}

}  // namespace docent::compile
