#include "runtime/motion/climb.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "runtime/motion/draft.h"
#include "runtime/motion/placement.h"
#include "runtime/motion/smoothing.h"
#include "runtime/motion/steps.h"

namespace docent::motion {
namespace {

constexpr double highest_step = 0.36;    // metres that a leg is lifted to from tread to tread
constexpr double least_tread = 0.20;     // metres that a foot goes forward at least
constexpr double most_tread = 0.45;      // metres; on deeper ones it takes two steps
constexpr double level_step = 0.34;      // metres of a step before and behind the flight
constexpr double toes = 0.09;            // metres of a foot before its ball
constexpr double heel = 0.19;            // metres of a foot behind its ball
constexpr double quickest = 0.5;         // seconds of a step
constexpr double slowest = 0.75;
constexpr double swing_share = 0.8;      // of a step's time
constexpr double least_turn = 0.05;      // radians that are not worth steps of their own
constexpr double take_over_time = 0.3;        // seconds in which the motion before is bent into this
constexpr float swing_a_metre = 0.45F;       // radians for a metre between the feet
constexpr float climbing_lean = 0.10F;            // radians of the trunk, climbing
constexpr double largest_drop = 0.25;   // metres that the hips sink for a foot further down
constexpr double smooth_seconds = 0.10;  // of what the upper body adds

/// Where a foot's ball is set down: metres along the way, and how high the ground is there.
struct Foothold {
  double along = 0;
  double height = 0;
};

/// The ball's place on a tread: climbing the toes stay before the next riser, descending the heel
/// comes down behind the edge.
double ball_on(const Treads& treads, double depth) noexcept {
  if (treads.riser > 0) return std::max(0.35 * depth, std::min(0.6 * depth, depth - toes));
  return std::clamp(heel, 0.5 * depth, std::max(0.5 * depth, depth - 0.02));
}

/// Level steps of one length from one place to another, without the last.
void add_level(double from, double to, double height, double farthest,
               std::vector<Foothold>& out) {
  const auto count = static_cast<int>(std::ceil((to - from) / level_step));
  for (int i = 1; i < count; ++i)
    out.push_back({std::min(from + (to - from) * i / count, farthest), height});
}

std::vector<Foothold> footholds_of(const Treads& treads, double begin, double end) {
  const int every = std::max(1, static_cast<int>(std::ceil(least_tread / treads.depth - 1e-9)));
  const int in_one = std::max(1, static_cast<int>(std::ceil(treads.depth / most_tread - 1e-9)));
  const double depth = treads.depth / in_one;
  std::vector<Foothold> holds;
  for (int i = every - 1; i < treads.count; i += every)
    for (int k = 0; k < in_one; ++k)
      holds.push_back({treads.begin(i) + k * depth + ball_on(treads, depth), treads.height(i)});
  std::vector<Foothold> all;
  const double edge = treads.near - (treads.riser > 0 ? toes : 0.03);
  if (!holds.empty()) add_level(begin, holds.front().along, 0, edge, all);
  all.insert(all.end(), holds.begin(), holds.end());
  const double behind = all.empty() ? begin : all.back().along;
  if (end > behind + 0.05) {
    add_level(behind, end, treads.rise(), end, all);
    all.push_back({end, treads.rise()});
  }
  return all;
}

class Climb {
 public:
  Climb(const WalkGraph& graph, const ClimbRequest& request)
      : graph_(graph),
        request_(request),
        length_(glm::distance(request.from, request.to)),
        along_((request.to - request.from) / length_),
        heading_(std::atan2(along_.y, along_.x)),
        momentum_(request.previous != nullptr
                      ? momentum_at(graph, *request.previous, request.previous_frame)
                      : momentum_of(graph, graph.after_walking, request.start)) {}

  Walk make() {
    turn_to(heading_);
    climb();
    turn_to(request_.final_heading);
    onto_slope();
    return std::move(walk_);
  }

 private:
  double along(Vec2 place) const noexcept { return dot(place - request_.from, along_); }

  void turn_to(double heading) {
    const double angle =
        std::remainder(heading - momentum_.body.heading, 2 * std::numbers::pi);
    if (std::abs(angle) <= least_turn) return;
    add(make_steps(graph_, momentum_, plan_turn(momentum_.body, angle, momentum_),
                   graph_.after_walking, Gait::Turn));
  }

  void climb() {
    const Stand& stand = graph_.after_walking;
    const double ahead = 0.5 * static_cast<double>(stand.foot[0].toe.x + stand.foot[1].toe.x);
    const double begin = along(momentum_.body.position);
    const std::vector<Foothold> holds =
        footholds_of(request_.treads, begin + ahead, length_ + ahead);
    Side foot = momentum_.planted[1] ? Side::Left : Side::Right;
    std::vector<Step> steps;
    const auto add_step = [&](const Foothold& hold) {
      const double station = hold.along - static_cast<double>(stand.foot[index_of(foot)].toe.x);
      steps.push_back({.foot = foot,
                       .station = {request_.from + station * along_, heading_},
                       .height = static_cast<float>(hold.height)});
      foot = other(foot);
    };
    for (const Foothold& hold : holds) add_step(hold);
    if (!holds.empty()) add_step(holds.back());
    const double each = std::clamp(
        request_.seconds / static_cast<double>(std::max<std::size_t>(steps.size(), 1)), quickest,
        slowest);
    Draft draft =
        make_steps(graph_, momentum_, steps, stand, Gait::Walk,
                   {.swing = swing_share * each, .support = (1 - swing_share) * each});
    move_upper_body(draft);
    for (std::size_t f = 0; f < draft.walk.along.size(); ++f)
      draft.walk.along[f] = static_cast<float>(
          std::clamp(along(draft.walk.body[f].position) - begin, 0.0, length_));
    add(std::move(draft));
    base_ = static_cast<float>(request_.treads.rise());
    momentum_.root.y -= base_;
    for (Foot& it : momentum_.foot) it.toe.y -= base_;
  }

  /// Turns a joint about an axis of the world.
  void turn(BodyPart part, Vec3 axis, float angle, PoseView& pose) const {
    const Skeleton& skeleton = graph_.motion->skeleton;
    const JointIndex joint = skeleton[part];
    if (joint == JointIndex::None) return;
    Quat parent(1, 0, 0, 0);
    for (JointIndex j = skeleton.joint[index_of(joint)].parent; j != JointIndex::None;
         j = skeleton.joint[index_of(j)].parent)
      parent = pose.rotation[index_of(j)] * parent;
    Quat& it = pose.rotation[index_of(joint)];
    it = glm::angleAxis(angle, glm::inverse(parent) * axis) * it;
  }

  /// Each arm swings with the other side's foot; who climbs leans into it.
  void move_upper_body(Draft& draft) const {
    const std::size_t frames = draft.walk.root.size();
    const Vec3 forwards = to_world(along_), left = to_world(left_of(along_));
    std::vector<double> apart(frames), leaning(frames);
    for (std::size_t f = 0; f < frames; ++f) {
      apart[f] = glm::dot(draft.foot[0][f].toe - draft.foot[1][f].toe, forwards);
      const double place = along(draft.walk.body[f].position);
      const Treads& treads = request_.treads;
      const bool climbs = treads.riser > 0 && place > treads.near - 0.3 &&
                          place < treads.begin(treads.count - 1);
      leaning[f] = climbs ? 1 : 0;
    }
    const auto swing =
        smooth_held(apart, gaussian_kernel(smooth_seconds * graph_.frame_rate));
    const auto leans =
        smooth_held(leaning, gaussian_kernel(4 * smooth_seconds * graph_.frame_rate));
    for (std::size_t f = 0; f < frames; ++f) {
      PoseView pose = pose_of(draft.walk, f);
      const float angle = swing_a_metre * static_cast<float>(swing[f] - swing.front());
      turn(BodyPart::Spine, left, climbing_lean * static_cast<float>(leans[f]), pose);
      turn(BodyPart::LeftShoulder, left, angle, pose);
      turn(BodyPart::RightShoulder, left, -angle, pose);
    }
  }

  void add(Draft draft) {
    inertialise(momentum_, take_over_time, draft);
    lower_hips(graph_, draft, largest_drop);
    place_feet(graph_, draft);
    append_at_base(std::move(draft));
  }

  void append_at_base(Draft draft) {
    for (Vec3& root : draft.walk.root) root.y += base_;
    append(std::move(draft), walk_);
    momentum_ = momentum_at(graph_, walk_, frame_count(walk_) - 1);
    momentum_.root.y -= base_;
    for (Foot& foot : momentum_.foot) foot.toe.y -= base_;
    momentum_.planted = {true, true};
  }

  /// Heights from above the floor where it began to above the line between the floors.
  void onto_slope() {
    for (std::size_t f = 0; f < walk_.root.size(); ++f) {
      const double share = std::clamp(along(walk_.body[f].position) / length_, 0.0, 1.0);
      walk_.root[f].y -= static_cast<float>(share * request_.treads.rise());
    }
  }

  const WalkGraph& graph_;
  const ClimbRequest& request_;
  double length_;
  Vec2 along_;
  double heading_;
  Momentum momentum_;
  float base_ = 0;  ///< Metres of the ground where the next part begins, above the first floor.
  Walk walk_;
};

}  // namespace

std::optional<Walk> make_climb(const WalkGraph& graph, const ClimbRequest& request) {
  const Treads& treads = request.treads;
  if (!(treads.depth > 0) || treads.count < 1) return {};
  const double every = std::max(1.0, std::ceil(least_tread / treads.depth - 1e-9));
  if (every * std::abs(treads.riser) > highest_step) return {};
  return Climb(graph, request).make();
}

}  // namespace docent::motion
