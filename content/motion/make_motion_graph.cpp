#include "content/motion/make_motion_graph.h"

#include <fmt/core.h>

#include <algorithm>

#include "content/content_error.h"
#include "content/motion/classify.h"
#include "content/motion/enrich.h"
#include "content/motion/foot_plants.h"
#include "content/motion/joint_pops.h"
#include "content/motion/made_stands.h"
#include "content/motion/motion_classes.h"
#include "content/motion/prune.h"
#include "content/motion/quantise.h"
#include "content/parallel.h"

namespace docent::motion::offline {
namespace {

Diagnostic warning(const std::string& file, std::string code, std::string message,
                   std::string hint) {
  return {.file = file,
          .severity = Severity::Warning,
          .code = std::move(code),
          .message = std::move(message),
          .hint = std::move(hint)};
}

/// What is known of a clip besides its motion. Where its joints are takes most of the memory that
/// an hour of motion needs, so that is never kept, but found again.
struct Study {
  std::vector<JointPop> popped;
  std::vector<CaptureFault> mended, left;
  double planted_height = 0;
  PoseCloud cloud;
};

std::vector<Study> study_motion(const Skeleton& skeleton, std::vector<SourceClip>& sources,
                                const MotionOptions& options) {
  const unsigned jobs = options.jobs;
  std::vector<Study> studies(sources.size());
  content::for_each_index(sources.size(), jobs, [&](std::size_t c) {
    MotionClip& clip = sources[c].clip;
    studies[c].popped = mend_joint_pops(skeleton, clip);
    JointPositions track = joint_positions(skeleton, clip);
    studies[c].mended = mend_capture_faults(skeleton, clip, track);
    studies[c].left = find_capture_faults(skeleton, clip, track);
    find_foot_plants(skeleton, track, clip);
    studies[c].planted_height = planted_height(skeleton, track, clip);
  });
  std::vector<double> heights;
  for (const Study& study : studies) heights.push_back(study.planted_height);
  const double rest = options.toe_rest.value_or(rest_height(skeleton, heights));
  content::for_each_index(sources.size(), jobs, [&](std::size_t c) {
    MotionClip& clip = sources[c].clip;
    level_ground(rest - heights[c], clip);
    quantise(skeleton, clip);  // what follows, down to foresight, is about what will be stored
    const JointPositions track = joint_positions(skeleton, clip);
    const ClipMeasures measures = measure_clip(skeleton, clip, track);
    if (!sources[c].role_stated) clip.role = classify(measures, size_of(skeleton));
    if (clip.motion_class.empty()) clip.motion_class = motion_class_of(measures, size_of(skeleton));
    if (clip.role != ClipRole::Other) studies[c].cloud = make_pose_cloud(skeleton, track);
  });
  return studies;
}

void report_faults(const Skeleton& skeleton, const SourceClip& source, const Study& study,
                   std::vector<Diagnostic>& warnings) {
  const auto warn_of_mending = [&](const std::string& what) {
    warnings.push_back(warning(source.file, "mended-fault", what + " and was mended",
                               "the frames beside it were joined smoothly; look whether the motion "
                               "is right there"));
  };
  for (const JointPop& pop : study.popped) warn_of_mending(describe(pop, skeleton));
  for (const CaptureFault& fault : study.mended) warn_of_mending(describe(fault, skeleton));
  for (const CaptureFault& fault : study.left)
    warnings.push_back(warning(source.file, "capture-fault", describe(fault, skeleton),
                               "no transition touches these frames; mend them in the recording "
                               "where they show"));
}

/// Adds clips that were made, and their study.
void add_made_clips(std::vector<MotionClip> made, MotionGraph& graph, StudiedClips& studied,
                    std::vector<std::string>& files) {
  for (MotionClip& clip : made) {
    quantise(graph.skeleton, clip);
    const JointPositions track = joint_positions(graph.skeleton, clip);
    studied.cloud.push_back(make_pose_cloud(graph.skeleton, track));
    studied.faults.push_back(find_capture_faults(graph.skeleton, clip, track));
    files.push_back(clip.name);
    graph.clips.push_back(std::move(clip));
  }
}

/// Moves what walks into the graph and its study.
StudiedClips take_walking_clips(std::vector<SourceClip>& sources, std::vector<Study>& studies,
                                MotionGraph& graph, std::vector<std::string>& files,
                                std::vector<Diagnostic>& warnings) {
  StudiedClips studied;
  for (std::size_t c = 0; c < sources.size(); ++c) {
    if (sources[c].clip.role == ClipRole::Other) {
      warnings.push_back(
          warning(sources[c].file, "not-walking",
                  "this clip neither walks nor runs and is left out of the motion graph",
                  "take it out of the folder, or state its role in clips.toml"));
      continue;
    }
    report_faults(graph.skeleton, sources[c], studies[c], warnings);
    graph.clips.push_back(std::move(sources[c].clip));
    files.push_back(sources[c].file);
    studied.cloud.push_back(std::move(studies[c].cloud));
    studied.faults.push_back(std::move(studies[c].left));
  }
  return studied;
}

/// Takes clips out that no transition touches.
void leave_out(const std::vector<std::size_t>& unused, MotionGraph& graph) {
  std::vector<std::uint32_t> place(graph.clips.size());
  std::vector<MotionClip> kept;
  for (std::size_t c = 0; c < graph.clips.size(); ++c) {
    place[c] = static_cast<std::uint32_t>(kept.size());
    if (!std::ranges::binary_search(unused, c)) kept.push_back(std::move(graph.clips[c]));
  }
  graph.clips = std::move(kept);
  for (Transition& t : graph.transitions) {
    t.from.clip = place[t.from.clip];
    t.to.clip = place[t.to.clip];
  }
}

void require_role(const MotionGraph& graph, ClipRole role, const std::string& folder,
                  const char* sentence) {
  const bool there = std::ranges::any_of(graph.transitions, [&](const Transition& t) {
    return graph.clips[role == ClipRole::Start ? t.from.clip : t.to.clip].role == role;
  });
  if (!there)
    throw content::ContentError(
        folder, 0, 0, "no-walk", sentence,
        "add such a clip of the same person and style; 'role' in clips.toml says "
        "what a clip is where its motion is not clear");
}

}  // namespace

MotionGraph make_motion_graph(const Skeleton& skeleton, std::vector<SourceClip> sources,
                              const std::string& folder, const MotionOptions& options,
                              std::vector<Diagnostic>& warnings) {
  std::vector<Study> studies = study_motion(skeleton, sources, options);
  MotionGraph graph{.skeleton = skeleton, .clips = {}, .transitions = {}};
  std::vector<std::string> files;
  StudiedClips studied = take_walking_clips(sources, studies, graph, files, warnings);
  std::vector<MotionClip> stands = made_stands(skeleton, graph.clips);
  for (const MotionClip& clip : stands)
    warnings.push_back(warning(folder, "made-clip",
                               fmt::format("there was no such clip, so '{}' was made", clip.name),
                               "a recorded one looks better: add a clip of the same person that "
                               "starts to walk from standing, and one that stops"));
  add_made_clips(std::move(stands), graph, studied, files);
  add_made_clips(enrich(skeleton, graph.clips, studied.cloud, options.enrichment, folder, warnings),
                 graph, studied, files);
  const std::vector<double> threshold = alike_thresholds(graph.clips, studied, options.transitions);
  graph.transitions =
      find_transitions(graph.clips, studied, threshold, options.transitions, options.jobs);
  const Pruning pruning = prune(graph);
  for (const std::size_t c : pruning.clips_outside)
    warnings.push_back(warning(files[c], "unused-clip",
                               "no transition joins this clip to the others",
                               "it is too unlike them; record it in the same style"));
  leave_out(pruning.clips_outside, graph);
  graph.classes = find_motion_classes(graph.skeleton, graph.clips);
  for (MotionClass& motion_class : graph.classes)
    motion_class.transition = own_graph(graph, motion_class.name);
  require_role(graph, ClipRole::Start, folder, "no clip starts to walk from standing");
  require_role(graph, ClipRole::Stop, folder, "no clip stops from walking to standing");
  return graph;
}

}  // namespace docent::motion::offline
