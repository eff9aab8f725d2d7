#include "content/motion/make_motion_graph.h"

#include <fmt/core.h>

#include <algorithm>

#include "content/content_error.h"
#include "content/motion/classify.h"
#include "content/motion/foot_plants.h"
#include "content/motion/prune.h"

namespace docent {
namespace {

Diagnostic warning(const std::string& file, std::string code, std::string message,
                   std::string hint) {
  return {.file = file,
          .severity = Severity::Warning,
          .code = std::move(code),
          .message = std::move(message),
          .hint = std::move(hint)};
}

/// Levels the ground, finds plants and roles, and returns where the joints are.
std::vector<Track> study_motion(const Skeleton& skeleton, std::vector<SourceClip>& sources) {
  std::vector<Track> tracks;
  std::vector<MotionClip> clips;
  for (SourceClip& source : sources) {
    tracks.push_back(make_track(skeleton, source.clip));
    find_foot_plants(skeleton, tracks.back(), source.clip);
    clips.push_back(std::move(source.clip));
  }
  level_ground(skeleton, clips, tracks);
  for (std::size_t c = 0; c < sources.size(); ++c) {
    if (!sources[c].role_stated)
      clips[c].role = classify(measure_clip(skeleton, clips[c], tracks[c]), size_of(skeleton));
    if (clips[c].motion_class.empty()) clips[c].motion_class = "walk";
    sources[c].clip = std::move(clips[c]);
  }
  return tracks;
}

void leave_out_other_motion(std::vector<SourceClip>& sources, std::vector<Track>& tracks,
                            std::vector<Diagnostic>& warnings) {
  for (std::size_t c = 0; c < sources.size();) {
    if (sources[c].clip.role != ClipRole::Other) {
      ++c;
      continue;
    }
    warnings.push_back(warning(sources[c].file, "not-walking",
                               "this clip does not walk and is left out of the motion graph",
                               "take it out of the folder, or state its role in clips.toml"));
    sources.erase(sources.begin() + static_cast<std::ptrdiff_t>(c));
    tracks.erase(tracks.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

StudiedClips study_poses(const Skeleton& skeleton, const std::vector<SourceClip>& sources,
                         const std::vector<Track>& tracks, std::vector<Diagnostic>& warnings) {
  StudiedClips studied;
  for (std::size_t c = 0; c < sources.size(); ++c) {
    studied.cloud.push_back(make_pose_cloud(skeleton, tracks[c]));
    studied.faults.push_back(find_capture_faults(skeleton, sources[c].clip, tracks[c]));
    for (const CaptureFault& fault : studied.faults.back())
      warnings.push_back(warning(sources[c].file, "capture-fault", describe(fault, skeleton),
                                 "no transition touches these frames; mend them in the recording "
                                 "where they show"));
  }
  return studied;
}

void require_role(const MotionGraph& graph, ClipRole role, const std::string& folder,
                  const char* sentence) {
  const bool there = std::ranges::any_of(graph.transitions, [&](const Transition& t) {
    return graph.clips[role == ClipRole::Start ? t.from.clip : t.to.clip].role == role;
  });
  if (!there)
    throw ContentError(folder, 0, 0, "no-walk", sentence,
                       "add such a clip of the same person and style; 'role' in clips.toml says "
                       "what a clip is where its motion is not clear");
}

}  // namespace

MotionGraph make_motion_graph(const Skeleton& skeleton, std::vector<SourceClip> sources,
                              const std::string& folder, const MotionOptions& options,
                              std::vector<Diagnostic>& warnings) {
  std::vector<Track> tracks = study_motion(skeleton, sources);
  leave_out_other_motion(sources, tracks, warnings);
  const StudiedClips studied = study_poses(skeleton, sources, tracks, warnings);

  MotionGraph graph{.skeleton = skeleton, .clips = {}, .transitions = {}};
  for (SourceClip& source : sources) graph.clips.push_back(std::move(source.clip));
  const double threshold = alike_threshold(graph.clips, studied, options.transitions);
  graph.transitions =
      find_transitions(graph.clips, studied, threshold, options.transitions, options.jobs);
  const Pruning pruning = prune(graph);
  for (const std::size_t c : pruning.clips_outside)
    warnings.push_back(warning(sources[c].file, "unused-clip",
                               "no transition joins this clip to the others",
                               "it is too unlike them; record it in the same style"));
  require_role(graph, ClipRole::Start, folder, "no clip starts to walk from standing");
  require_role(graph, ClipRole::Stop, folder, "no clip stops from walking to standing");
  return graph;
}

}  // namespace docent
