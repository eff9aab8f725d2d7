#include "content/motion/paper_track.h"

#include <cstddef>

namespace docent::motion::offline {
namespace {

/// Writes frames of clips, laid onto the floor, until there are as many as the path has.
class TrackWriter {
 public:
  TrackWriter(const MotionGraph& graph, const Placement& clip_to_floor, std::uint32_t frames)
      : graph_(graph), clip_to_floor_(clip_to_floor), frames_(frames) {}

  void copy(std::uint32_t clip, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t f = first; f < last && !is_full(); ++f) add({clip, f});
  }

  void cross(const PassedTransition& passed) {
    const Transition& way = graph_.transitions[passed.transition];
    const Placement destination = carried(clip_to_floor_, way.alignment);
    for (std::uint32_t i = 0; i < 2 * passed.radius && !is_full(); ++i) {
      add({way.from.clip, way.from.frame - passed.radius + i});
      mix({way.to.clip, way.to.frame - passed.radius + i}, destination,
          static_cast<float>(blend_share(i, passed.radius)));
    }
    clip_to_floor_ = destination;
  }

  PaperTrack take() { return std::move(track_); }

 private:
  bool is_full() const noexcept { return track_.root.size() == frames_; }

  static Quat turn_of(const Placement& motion) {
    return glm::angleAxis(static_cast<float>(motion.heading), Vec3(0, 1, 0));
  }

  static Vec3 root_of(const MotionClip& clip, std::uint32_t frame, const Placement& motion) {
    const Vec3 root = clip.root[frame];
    return to_world(carried(motion, to_floor(root)), static_cast<double>(root.y));
  }

  void add(ClipFrame frame) {
    const MotionClip& clip = graph_.clips[frame.clip];
    track_.root.push_back(root_of(clip, frame.frame, clip_to_floor_));
    const auto first =
        clip.rotation.begin() + static_cast<std::ptrdiff_t>(frame.frame) * clip.joint_count;
    const std::size_t at = track_.rotation.size();
    track_.rotation.insert(track_.rotation.end(), first, first + clip.joint_count);
    track_.rotation[at] = turn_of(clip_to_floor_) * track_.rotation[at];
    track_.source.push_back(frame);
  }

  /// Turns the last frame by a share into another one.
  void mix(ClipFrame frame, const Placement& motion, float share) {
    const MotionClip& clip = graph_.clips[frame.clip];
    Vec3& root = track_.root.back();
    root = glm::mix(root, root_of(clip, frame.frame, motion), share);
    Quat* out = track_.rotation.data() + track_.rotation.size() - clip.joint_count;
    const Quat* other = clip.rotation.data() + std::size_t{frame.frame} * clip.joint_count;
    for (std::uint32_t j = 0; j < clip.joint_count; ++j)
      out[j] =
          glm::normalize(glm::slerp(out[j], j == 0 ? turn_of(motion) * other[0] : other[j], share));
    if (share >= 0.5f) track_.source.back() = frame;
  }

  const MotionGraph& graph_;
  Placement clip_to_floor_;
  std::uint32_t frames_;
  PaperTrack track_;
};

}  // namespace

PaperTrack make_paper_track(const MotionGraph& graph, const PaperPath& path,
                            const Placement& clip_to_floor) {
  TrackWriter writer(graph, clip_to_floor, path.frames);
  ClipFrame at = path.start;
  for (const PassedTransition& passed : path.passed) {
    const Transition& way = graph.transitions[passed.transition];
    writer.copy(at.clip, at.frame, way.from.frame - passed.radius);
    writer.cross(passed);
    at = {way.to.clip, way.to.frame + passed.radius};
  }
  writer.copy(at.clip, at.frame, path.last_frame + 1);
  return writer.take();
}

}  // namespace docent::motion::offline
