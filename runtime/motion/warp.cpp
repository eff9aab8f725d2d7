#include "runtime/motion/warp.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/placement.h"
#include "runtime/motion/replant.h"
#include "runtime/motion/smoothing.h"

namespace docent::motion {
namespace {

constexpr double turn_in_seconds = 0.9;  // time in which a body takes up the track's heading
constexpr double join_seconds = 0.6;     // time in which it takes up the track's direction

/// A moment between two frames of a sequence.
struct SequenceMoment {
  std::size_t frame = 0;
  double share = 0;  ///< Of the next frame.
};

/// Frames are added one by one, so room for them is made first.
void make_room(std::size_t frames, Walk& walk) {
  walk.root.reserve(frames), walk.rotation.reserve(frames * walk.joint_count);
  walk.plants.reserve(frames), walk.body.reserve(frames), walk.along.reserve(frames);
  walk.gait.reserve(frames), walk.source.reserve(frames);
}

void add_pose(const WalkGraph& graph, const ClipSequence& sequence, SequenceMoment at,
              const Placement& body, Draft& draft) {
  const std::size_t joints = graph.motion->skeleton.joint.size();
  const std::size_t next = std::min(at.frame + 1, sequence.root.size() - 1);
  const auto share = static_cast<float>(at.share);
  const Placement& a = sequence.body[at.frame];
  const Placement& b = sequence.body[next];
  const Placement own{glm::mix(a.position, b.position, at.share),
                      glm::mix(a.heading, b.heading, at.share)};
  const double turn = body.heading - own.heading;
  Walk& walk = draft.walk;
  const Vec3 root = glm::mix(sequence.root[at.frame], sequence.root[next], share);
  walk.root.push_back(
      to_world(body.position + turned(to_floor(root) - own.position, turn), root.y));
  const Quat* first = sequence.rotation.data() + at.frame * joints;
  const Quat* second = sequence.rotation.data() + next * joints;
  const std::size_t start = walk.rotation.size();
  for (std::size_t j = 0; j < joints; ++j) {
    const Quat to = glm::dot(first[j], second[j]) < 0 ? -second[j] : second[j];
    walk.rotation.push_back(glm::normalize(first[j] * (1 - share) + to * share));
  }
  walk.rotation[start] = world_rotation(turn) * walk.rotation[start];
  const std::size_t nearest = at.share < 0.5 ? at.frame : next;
  walk.plants.push_back({sequence.contact[0][nearest], sequence.contact[1][nearest]});
  walk.source.push_back(sequence.source[nearest]);
  walk.body.push_back(body);
  walk.gait.push_back(Gait::Walk);
}

/// Writes down where a foot is in each frame, and says where its hip joint is.
std::vector<Vec3> find_feet(const WalkGraph& graph, Side side, Draft& draft) {
  const Leg& leg = graph.legs[side];
  const std::size_t i = index_of(side), frames = draft.walk.root.size();
  std::vector<Vec3> hips;
  hips.reserve(frames), draft.foot[i].reserve(frames), draft.reach[i].reserve(frames);
  for (std::size_t f = 0; f < frames; ++f) {
    const LegPose at = leg_pose(graph.motion->skeleton, leg, pose_of(draft.walk, f));
    draft.foot[i].push_back({at.position[leg.toe], at.rotation[leg.ankle]});
    draft.reach[i].push_back(glm::distance(at.position[leg.hip], at.position[leg.ankle]));
    hips.push_back(at.position[leg.hip]);
  }
  return hips;
}

bool& planted(FootPlants& plants, Side side) {
  return side == Side::Left ? plants.left : plants.right;
}

void plant_feet(const WalkGraph& graph, Side side, const Momentum& momentum, std::uint32_t seed,
                Draft& draft) {
  const std::size_t i = index_of(side), frames = draft.walk.root.size();
  const std::vector<Vec3> hips = find_feet(graph, side, draft);
  std::vector<bool> contact(frames);
  for (std::size_t f = 0; f < frames; ++f) contact[f] = planted(draft.walk.plants[f], side);
  replant(graph, side, draft.foot[i], hips, contact, {momentum.foot[i], momentum.foot_velocity[i]},
          momentum.planted[i], seed);
  for (std::size_t f = 0; f < frames; ++f) planted(draft.walk.plants[f], side) = contact[f];
}

/// The difference between how the body moves at first and how the track begins, which fades.
class Joining {
 public:
  Joining(const Momentum& momentum, const PathTrack& track, double first_speed) {
    const double heading = track.heading.front();
    turn_ = wrap_angle(momentum.body.heading - heading);
    turn_rate_ = momentum.body_velocity.heading;
    offset_ = momentum.body.position - track.position.front();
    const Vec2 along =
        glm::normalize(track.position[1] - track.position[0] + Vec2(1e-12, 0)) * first_speed;
    drift_ = momentum.body_velocity.position - along;
  }

  Placement bent(Placement body, double seconds) const {
    body.position += fade(offset_, drift_, seconds / join_seconds, join_seconds);
    body.heading += fade(turn_, turn_rate_, seconds / turn_in_seconds, turn_in_seconds);
    return body;
  }

 private:
  template <typename Value>
  static Value fade(Value value, Value slope, double t, double duration) {
    if (t >= 1) return Value{};
    return (1 - t * t * t * (10 - t * (15 - 6 * t))) * value +
           (t - t * t * t * (6 - t * (8 - 3 * t))) * duration * slope;
  }

  Vec2 offset_{}, drift_{};
  double turn_ = 0, turn_rate_ = 0;
};

}  // namespace

Draft warp_onto(const WalkGraph& graph, const ClipSequence& sequence, const PathTrack& track,
                const Momentum& momentum, std::uint32_t seed) {
  Draft draft = empty_draft(graph);
  make_room(3 * (sequence.root.size() - sequence.first) / 2, draft.walk);
  const double walked = sequence.effort.back();
  const double stretch = walked > 1e-6 ? track.effort.back() / walked : 0;
  const std::size_t last = sequence.root.size() - 1;
  const double first_step =
      last > sequence.first ? sequence.effort[sequence.first + 1] * stretch : 0;
  const Joining joining(
      momentum, track,
      first_step * graph.frame_rate * track.stride.front() * track.cadence.front());
  std::size_t hint = 0;
  for (double at = static_cast<double>(sequence.first);;) {
    const auto frame = std::min(static_cast<std::size_t>(at), last);
    const SequenceMoment moment{
        frame, std::min(at, static_cast<double>(last)) - static_cast<double>(frame)};
    const std::size_t next = std::min(frame + 1, last);
    const double effort =
        stretch * glm::mix(sequence.effort[frame], sequence.effort[next], moment.share);
    const TrackPoint point = at_effort(track, effort, hint);
    const double seconds = static_cast<double>(draft.walk.root.size()) / graph.frame_rate;
    add_pose(graph, sequence, moment, joining.bent(point.placement, seconds), draft);
    draft.walk.along.push_back(static_cast<float>(point.along));
    if (at >= static_cast<double>(last)) break;
    at += point.cadence;
  }
  for (const Side side : both_sides) plant_feet(graph, side, momentum, seed, draft);
  return draft;
}

Draft as_it_is(const WalkGraph& graph, const ClipSequence& sequence) {
  Draft draft = empty_draft(graph);
  make_room(sequence.root.size() - sequence.first, draft.walk);
  for (std::size_t f = sequence.first; f < sequence.root.size(); ++f) {
    add_pose(graph, sequence, {f, 0}, sequence.body[f], draft);
    draft.walk.along.push_back(static_cast<float>(sequence.effort[f]));
  }
  for (const Side side : both_sides) find_feet(graph, side, draft);
  return draft;
}

}  // namespace docent::motion
