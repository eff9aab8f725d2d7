#include "runtime/motion/steps.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "runtime/motion/placement.h"
#include "runtime/motion/replant.h"
#include "runtime/motion/smoothing.h"

namespace docent::motion {
namespace {

constexpr double largest_turn = 1.05;     // radians that one pair of steps turns the body by
constexpr double longest_step = 0.30;     // metres that one short step moves the body by
constexpr double swing_seconds = 0.42;    // a foot is in the air
constexpr double support_seconds = 0.08;  // both are on the ground, between two steps
constexpr double lead_seconds = 0.22;     // weight shifts before the first foot leaves the ground
constexpr double settle_seconds = 0.35;   // weight comes back to the middle after the last
constexpr float lift_height = 0.045f;     // metres of the toe joint
constexpr float heel_up = 0.35f;          // radians that the heel leads the toe off the ground
constexpr float weight_share = 0.6f;      // of the way from the middle to over the standing foot
constexpr double weight_bell = 0.11;      // seconds: standard deviation of the shift's smoothing
constexpr double head_lead = 0.35;        // share of the turn still to come that the head shows
constexpr double most_head_lead = 0.55;   // radians

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10 - t * (15 - 6 * t));
}

/// What a step does, in time.
struct TimedStep {
  Step step;
  double lift = 0, land = 0;  ///< Seconds.
  Foot from, to;
};

Foot placed(const Foot& foot, const Placement& station) {
  return {moved(station, foot.toe), world_rotation(station.heading) * foot.rotation};
}

Placement between(const Placement& a, const Placement& b, double t) {
  return {glm::mix(a.position, b.position, t), glm::mix(a.heading, b.heading, t)};
}

class Stepping {
 public:
  Stepping(const WalkGraph& graph, const Momentum& momentum, std::span<const Step> steps,
           const Stand& goal, Gait gait)
      : graph_(graph), momentum_(momentum), goal_(goal), gait_(gait) {
    schedule(steps);
  }

  Draft make() {
    Draft draft = empty_draft(graph_);
    const auto frames = static_cast<std::size_t>(std::ceil(seconds_ * graph_.frame_rate)) + 1;
    find_body(frames);
    for (std::size_t f = 0; f < frames; ++f) add_frame(f, draft);
    return draft;
  }

 private:
  void schedule(std::span<const Step> steps) {
    std::array<Foot, 2> foot = momentum_.foot;
    double now = lead_seconds;
    for (const Step& step : steps) {
      const std::size_t i = index_of(step.foot);
      const bool in_the_air = steps_.empty() && !momentum_.planted[i];
      if (in_the_air) now = 0;
      const Foot to = placed(goal_.foot[i], step.station);
      steps_.push_back({step, now, now + swing_seconds, foot[i], to});
      foot[i] = to;
      now += swing_seconds + support_seconds;
    }
    seconds_ = now - support_seconds + settle_seconds;
  }

  /// The body follows its feet: it is where the mean of their stations is, smoothly.
  void find_body(std::size_t frames) {
    std::array<Placement, 2> station{momentum_.body, momentum_.body};
    std::vector<double> x(frames), y(frames), heading(frames), side_x(frames), side_y(frames);
    std::size_t done = 0;
    for (std::size_t f = 0; f < frames; ++f) {
      const double now = seconds_at(f);
      while (done < steps_.size() && now >= steps_[done].land) {
        station[index_of(steps_[done].step.foot)] = steps_[done].step.station;
        ++done;
      }
      std::array<Placement, 2> present = station;
      Vec2 weight{};
      if (done < steps_.size()) {
        const TimedStep& step = steps_[done];
        const std::size_t i = index_of(step.step.foot);
        // The weight moves a little before the foot does.
        const double t = (now - step.lift) / (step.land - step.lift);
        present[i] = between(station[i], step.step.station, std::clamp(t, 0.0, 1.0));
        if (now >= step.lift - lead_seconds)
          weight = over_standing_foot(other(step.step.foot), done);
      }
      const Placement body = between(present[0], present[1], 0.5);
      x[f] = body.position.x, y[f] = body.position.y, heading[f] = body.heading;
      const Vec2 shift = static_cast<double>(weight_share) * weight_from(weight, body, done);
      side_x[f] = shift.x, side_y[f] = shift.y;
    }
    const auto kernel = gaussian_kernel(weight_bell * graph_.frame_rate);
    x = smooth_held(x, kernel), y = smooth_held(y, kernel), heading = smooth_held(heading, kernel);
    side_x = smooth_held(side_x, kernel), side_y = smooth_held(side_y, kernel);
    for (std::size_t f = 0; f < frames; ++f) {
      body_.push_back({{x[f], y[f]}, heading[f]});
      // No shift at the very ends, where the stretch joins its neighbours.
      const double fade = smooth_step(seconds_at(f) / lead_seconds) *
                          smooth_step((seconds_ - seconds_at(f)) / settle_seconds);
      weight_.push_back(fade * Vec2(side_x[f], side_y[f]));
    }
  }

  /// Where the foot stands that bears the weight during a step.
  Vec2 over_standing_foot(Side side, std::size_t step) const {
    Foot foot = momentum_.foot[index_of(side)];
    for (std::size_t s = 0; s < step; ++s)
      if (steps_[s].step.foot == side) foot = steps_[s].to;
    return to_floor(ankle_of(graph_.legs[side], foot));
  }

  Vec2 weight_from(Vec2 standing, const Placement& body, std::size_t step) const {
    if (step >= steps_.size() || standing == Vec2{}) return {};
    const Vec2 offset = standing - body.position;
    const Vec2 sideways = left_of({std::cos(body.heading), std::sin(body.heading)});
    return dot(offset, sideways) * sideways;
  }

  void add_frame(std::size_t f, Draft& draft) {
    const double now = seconds_at(f);
    const auto share = static_cast<float>(smooth_step(now / seconds_));
    Walk& walk = draft.walk;
    const Placement& body = body_[f];
    const Vec3 own_root = moved(inverse(momentum_.body), momentum_.root);
    Vec3 root = moved(body, glm::mix(own_root, goal_.root, share));
    root += to_world(weight_[f]) - Vec3(0, 0.25f * static_cast<float>(glm::length(weight_[f])), 0);
    walk.root.push_back(root);
    const std::size_t joints = walk.joint_count, start = walk.rotation.size();
    for (std::size_t j = 0; j < joints; ++j) {
      const Quat from = j == 0 ? world_rotation(-momentum_.body.heading) * momentum_.rotation[0]
                               : momentum_.rotation[j];
      walk.rotation.push_back(glm::slerp(from, goal_.rotation[j], share));
    }
    walk.rotation[start] = world_rotation(body.heading) * walk.rotation[start];
    turn_head(walk, f);
    walk.body.push_back(body);
    walk.along.push_back(0);
    walk.gait.push_back(gait_);
    walk.source.push_back(stand_frame());
    FootPlants plants{true, true};
    for (const Side side : both_sides) {
      bool planted = true;
      const Foot foot = foot_at(side, now, planted);
      (side == Side::Left ? plants.left : plants.right) = planted;
      draft.foot[index_of(side)].push_back(foot);
      draft.reach[index_of(side)].push_back(0);
    }
    walk.plants.push_back(plants);
  }

  /// The frame that a stand like the goal's comes from.
  ClipFrame stand_frame() const {
    const std::uint32_t clip = graph_.stops.front();
    return {clip, graph_.clip[clip].last};
  }

  Foot foot_at(Side side, double now, bool& planted) const {
    const std::size_t i = index_of(side);
    Foot foot = momentum_.foot[i];
    for (const TimedStep& step : steps_) {
      if (step.step.foot != side || now < step.lift) continue;
      if (now >= step.land) {
        foot = step.to;
        continue;
      }
      planted = false;
      return swinging(step, graph_.legs[side], (now - step.lift) / (step.land - step.lift));
    }
    return foot;
  }

  /// Up with the heel first, over, and down flat. It moves across only while it is clear of the
  /// ground.
  static Foot swinging(const TimedStep& step, const Leg& leg, double t) {
    const auto across = static_cast<float>(smooth_step((t - 0.15) / 0.7));
    const auto rise = static_cast<float>(std::pow(std::sin(t * 3.14159265358979), 2));
    const auto pitch =
        static_cast<float>(std::pow(std::sin(std::min(1.0, t * 1.4) * 3.14159265358979), 2));
    Foot foot;
    foot.toe = glm::mix(step.from.toe, step.to.toe, across);
    foot.toe.y += lift_height * rise;
    foot.rotation = glm::slerp(step.from.rotation, step.to.rotation, across);
    const Vec3 forwards = foot.rotation * leg.ankle_to_toe;
    const Vec3 axis = glm::normalize(glm::cross(Vec3(0, 1, 0), Vec3(forwards.x, 0, forwards.z)));
    foot.rotation = glm::angleAxis(heel_up * pitch, axis) * foot.rotation;
    return foot;
  }

  /// Turns neck and head towards where the turn goes, each by half.
  void turn_head(Walk& walk, std::size_t f) const {
    const double left = body_.back().heading - body_[f].heading;
    const double lead = std::clamp(head_lead * left, -most_head_lead, most_head_lead) *
                        smooth_step(seconds_at(f) / (2 * lead_seconds));
    const Skeleton& skeleton = graph_.motion->skeleton;
    PoseView pose = pose_of(walk, f);
    for (const BodyPart part : {BodyPart::Neck, BodyPart::Head}) {
      const JointIndex joint = skeleton[part];
      if (joint == JointIndex::None || joint == skeleton[BodyPart::Hips]) continue;
      Quat parent(1, 0, 0, 0);
      for (JointIndex j = skeleton.joint[index_of(joint)].parent; j != JointIndex::None;
           j = skeleton.joint[index_of(j)].parent)
        parent = pose.rotation[index_of(j)] * parent;
      const Quat turn = glm::angleAxis(static_cast<float>(lead / 2),
                                       glm::normalize(glm::inverse(parent) * Vec3(0, 1, 0)));
      pose.rotation[index_of(joint)] = turn * pose.rotation[index_of(joint)];
    }
  }

  double seconds_at(std::size_t frame) const {
    return static_cast<double>(frame) / graph_.frame_rate;
  }

  const WalkGraph& graph_;
  const Momentum& momentum_;
  const Stand& goal_;
  Gait gait_;
  std::vector<TimedStep> steps_;
  double seconds_ = 0;
  std::vector<Placement> body_;
  std::vector<Vec2> weight_;
};

}  // namespace

std::vector<Step> plan_turn(const Placement& from, double angle, const Momentum& momentum) {
  const auto pairs = static_cast<int>(std::max(1.0, std::ceil(std::abs(angle) / largest_turn)));
  Side lead = angle > 0 ? Side::Left : Side::Right;
  for (const Side side : both_sides)
    if (!momentum.planted[index_of(side)]) lead = side;
  std::vector<Step> steps;
  for (int pair = 1; pair <= pairs; ++pair) {
    const Placement station{from.position, from.heading + angle * pair / pairs};
    steps.push_back({lead, station});
    steps.push_back({other(lead), station});
  }
  return steps;
}

std::vector<Step> plan_short_walk(const PathTrack& track, const Momentum& momentum) {
  const auto count = static_cast<int>(std::max(1.0, std::ceil(track.length() / longest_step)));
  Side foot = momentum.planted[1] ? Side::Left : Side::Right;
  std::vector<Step> steps;
  std::size_t hint = 0;
  Placement last = momentum.body;
  for (int i = 1; i <= count; ++i) {
    const double effort = track.effort.back() * i / count;
    Placement next = at_effort(track, effort, hint).placement;
    const double turn = wrap_angle(next.heading - last.heading);
    next.heading = last.heading + turn;
    const double parts = std::ceil(std::abs(turn) / largest_turn);
    for (double part = 1; part < parts; ++part) {  // first on the spot, where it turns sharply
      const Placement station{last.position, last.heading + turn * part / parts};
      steps.push_back({foot, station});
      steps.push_back({other(foot), station});
    }
    steps.push_back({foot, next});
    foot = other(foot);
    last = next;
  }
  steps.push_back({foot, steps.back().station});
  return steps;
}

Draft make_steps(const WalkGraph& graph, const Momentum& momentum, std::span<const Step> steps,
                 const Stand& goal, Gait gait) {
  return Stepping(graph, momentum, steps, goal, gait).make();
}

}  // namespace docent::motion
