#include "runtime/motion/clip_sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/motion/placement.h"
#include "runtime/motion/smoothing.h"

namespace docent::motion {
namespace {

/// Per frame of a sequence, what is known of its clips' frames already.
struct SequenceParts {
  std::vector<double> facing;                ///< Radians.
  std::array<std::vector<LegEnds>, 2> ends;  ///< Per side.
};

/// Writes frames of clips, laid onto the floor, one after another.
class Player {
 public:
  Player(const WalkGraph& graph, ClipSequence& sequence, SequenceParts& parts)
      : graph_(graph), sequence_(sequence), parts_(parts) {}

  void make_room(std::size_t frames) {
    sequence_.root.reserve(frames), sequence_.source.reserve(frames);
    sequence_.rotation.reserve(frames * joint_count());
    parts_.facing.reserve(frames);
    for (auto& ends : parts_.ends) ends.reserve(frames);
  }
  void lay_clip(const Placement& clip_to_floor) {
    clip_to_floor_ = clip_to_floor;
    turn_ = world_rotation(clip_to_floor.heading);
    origin_ = to_world(clip_to_floor.position, 0);
  }
  void follow(const Placement& alignment) { lay_clip(compose(clip_to_floor_, alignment)); }

  void copy(std::uint32_t clip, std::size_t from, std::size_t to) {
    for (std::size_t f = from; f < to; ++f) add({clip, static_cast<std::uint32_t>(f)});
  }

  /// Blends 2 * radius frames about a transition's two middles and goes on in the destination.
  void cross(const Transition& way, std::size_t radius) {
    const Placement destination = compose(clip_to_floor_, way.alignment);
    const std::uint32_t joints = joint_count();
    for (std::size_t i = 0; i < 2 * radius; ++i) {
      const auto step = static_cast<std::uint32_t>(i);
      const auto r = static_cast<std::uint32_t>(radius);
      const ClipFrame from{way.from.clip, way.from.frame - r + step};
      const ClipFrame to{way.to.clip, way.to.frame - r + step};
      const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(2 * radius);
      const auto share = static_cast<float>(t * t * t * (t * (6 * t - 15) + 10));
      add(from);
      const MotionClip& clip = motion().clips[to.clip];
      sequence_.root.back() =
          glm::mix(sequence_.root.back(), moved(destination, clip.root[to.frame]), share);
      if (share >= 0.5f) sequence_.source.back() = to;
      Quat* out = sequence_.rotation.data() + sequence_.rotation.size() - joints;
      const Quat* other = clip.rotation.data() + std::size_t{to.frame} * joints;
      const Quat turn = world_rotation(destination.heading);
      for (std::uint32_t j = 0; j < joints; ++j)
        out[j] = glm::normalize(glm::slerp(out[j], j == 0 ? turn * other[0] : other[j], share));
      measure_last();
    }
    lay_clip(destination);
  }

 private:
  const MotionGraph& motion() const { return *graph_.motion; }
  std::uint32_t joint_count() const { return motion().clips.front().joint_count; }

  void add(ClipFrame frame) {
    const MotionClip& clip = motion().clips[frame.clip];
    sequence_.root.push_back(origin_ + turn_ * clip.root[frame.frame]);
    const auto first =
        clip.rotation.begin() + static_cast<std::ptrdiff_t>(frame.frame) * clip.joint_count;
    const std::size_t at = sequence_.rotation.size();
    sequence_.rotation.insert(sequence_.rotation.end(), first, first + clip.joint_count);
    sequence_.rotation[at] = turn_ * sequence_.rotation[at];
    sequence_.source.push_back(frame);
    const ClipPath& path = graph_.clip[frame.clip];
    parts_.facing.push_back(path.facing[frame.frame] + clip_to_floor_.heading);
    for (const Side side : both_sides) {
      const LegEnds& ends = path.ends[index_of(side)][frame.frame];
      parts_.ends[index_of(side)].push_back(
          {origin_ + turn_ * ends.toe, origin_ + turn_ * ends.ankle});
    }
  }

  /// Of a frame that is blended of two.
  void measure_last() {
    const Skeleton& skeleton = motion().skeleton;
    const std::size_t joints = joint_count();
    const PoseView pose{sequence_.root.back(), std::span(sequence_.rotation).last(joints)};
    parts_.facing.back() = facing(skeleton, graph_.legs, pose);
    for (const Side side : both_sides) {
      const Leg& leg = graph_.legs[side];
      const LegPose at = leg_pose(skeleton, leg, pose);
      parts_.ends[index_of(side)].back() = {at.position[leg.toe], at.position[leg.ankle]};
    }
  }

  const WalkGraph& graph_;
  ClipSequence& sequence_;
  SequenceParts& parts_;
  Placement clip_to_floor_;
  Quat turn_{1, 0, 0, 0};  ///< The same, in the world.
  Vec3 origin_{};
};

void find_body(const WalkGraph& graph, std::vector<double> headings, ClipSequence& sequence) {
  std::vector<Vec2> roots(sequence.root.size());
  std::ranges::transform(sequence.root, roots.begin(), to_floor);
  unwrap_angles(headings);
  sequence.body = body_track(roots, headings, graph.stride_seconds * graph.frame_rate);
  sequence.effort = effort_along(sequence.body);
  const double run_up = sequence.effort[sequence.first];
  for (double& effort : sequence.effort) effort -= run_up;
}

constexpr float touching_height = 0.015f;  // metres above the toe joint's resting height
constexpr float rolling_height = 0.03f;   // metres: contact lasts until the toe has left the ground
constexpr float flat_height = 0.02f;      // metres above the ankle joint's resting height
constexpr float rolling_speed = 0.35f;    // metres a second of the toe joint
constexpr float landing_speed = 1.2f;     // metres a second: a flat foot brakes from it at once
constexpr double shortest_contact = 0.1;  // seconds
constexpr double longest_gap = 0.05;      // seconds

/// Joins contacts that a flicker parted, and drops those that are too short to bear a body.
void tidy_contacts(std::vector<bool>& contact, double frame_rate) {
  const auto flip_short_runs = [&](bool value, double seconds) {
    const auto shortest = static_cast<std::size_t>(seconds * frame_rate);
    for (std::size_t f = 0; f < contact.size();) {
      std::size_t end = f;
      while (end < contact.size() && contact[end] == contact[f]) ++end;
      const bool inside = f > 0 && end < contact.size();
      if (contact[f] == value && inside && end - f < shortest)
        std::fill(contact.begin() + static_cast<std::ptrdiff_t>(f),
                  contact.begin() + static_cast<std::ptrdiff_t>(end), !value);
      f = end;
    }
  };
  flip_short_runs(false, longest_gap);
  flip_short_runs(true, shortest_contact);
}

/// When the toe joint rests on the ground: from when the clip's own plants say so, and while the
/// foot still rolls over it, which plants (a flat and still foot) leave out.
void find_contacts(const WalkGraph& graph, const std::vector<LegEnds>& ends, Side side,
                   ClipSequence& sequence) {
  const std::size_t frames = sequence.root.size();
  std::vector<bool> planted(frames);
  for (std::size_t f = 0; f < frames; ++f) {
    const FootPlants plants =
        graph.motion->clips[sequence.source[f].clip].plants[sequence.source[f].frame];
    planted[f] = side == Side::Left ? plants.left : plants.right;
  }
  const float rest = graph.toe_height[index_of(side)];
  const auto speed = [&](std::size_t f) {
    const std::size_t a = f > 1 ? f - 2 : 0, b = std::min(f + 2, frames - 1);
    const Vec3 step = ends[b].toe - ends[a].toe;
    return std::hypot(step.x, step.z) * static_cast<float>(graph.frame_rate) /
           static_cast<float>(std::max<std::size_t>(b - a, 1));
  };
  const auto rolls = [&](std::size_t f) {
    return ends[f].toe.y < rest + rolling_height && speed(f) < rolling_speed;
  };
  const auto has_landed = [&](std::size_t f) {
    const bool flat = ends[f].ankle.y < graph.ankle_height[index_of(side)] + flat_height;
    return ends[f].toe.y < rest + touching_height &&
           speed(f) < (flat ? landing_speed : rolling_speed);
  };
  std::vector<bool>& contact = sequence.contact[index_of(side)];
  contact = planted;
  for (std::size_t f = 1; f < frames; ++f)
    if (contact[f - 1] && rolls(f)) contact[f] = true;
  for (std::size_t f = frames; f-- > 1;)
    if (contact[f] && has_landed(f - 1)) contact[f - 1] = true;
  tidy_contacts(contact, graph.frame_rate);
}

std::size_t frames_of(const WalkGraph& graph, const MotionPlan& plan) {
  std::size_t frames = 0, at = plan.start.frame;
  for (const std::uint32_t t : plan.transitions) {
    const Transition& way = graph.motion->transitions[t];
    frames += way.from.frame - at;
    at = way.to.frame;
  }
  return frames + plan.last_frame + 1 - at;
}

}  // namespace

ClipSequence play(const WalkGraph& graph, const MotionPlan& plan, const Placement& clip_to_floor) {
  ClipSequence sequence;
  SequenceParts parts;
  Player player(graph, sequence, parts);
  player.lay_clip(clip_to_floor);
  const auto run_up = static_cast<std::uint32_t>(graph.stride_seconds * graph.frame_rate);
  const bool from_standing = graph.motion->clips[plan.start.clip].role == ClipRole::Start &&
                             plan.start.frame <= graph.clip[plan.start.clip].first;
  std::size_t frame =
      from_standing ? plan.start.frame : plan.start.frame - std::min(plan.start.frame, run_up);
  sequence.first = plan.start.frame - frame;
  player.make_room(frames_of(graph, plan) + sequence.first);
  std::size_t earliest = plan.start.frame;  // a blend must not reach into the run-up
  std::uint32_t clip = plan.start.clip;
  for (const std::uint32_t t : plan.transitions) {
    const Transition& way = graph.motion->transitions[t];
    const std::size_t most =
        std::min<std::size_t>({way.from.frame - earliest, way.to.frame,
                               frame_count(graph.motion->clips[way.from.clip]) - way.from.frame,
                               frame_count(graph.motion->clips[way.to.clip]) - way.to.frame});
    const std::size_t radius = std::min<std::size_t>(way.radius, most);
    player.copy(clip, frame, way.from.frame - radius);
    if (radius > 0)
      player.cross(way, radius);
    else
      player.follow(way.alignment);
    clip = way.to.clip;
    earliest = frame = way.to.frame + radius;
  }
  player.copy(clip, frame, plan.last_frame + 1);
  find_body(graph, std::move(parts.facing), sequence);
  for (const Side side : both_sides)
    find_contacts(graph, parts.ends[index_of(side)], side, sequence);
  return sequence;
}

}  // namespace docent::motion
