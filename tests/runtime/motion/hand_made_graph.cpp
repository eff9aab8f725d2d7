#include "tests/runtime/motion/hand_made_graph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "runtime/motion/leg.h"
#include "runtime/motion/placement.h"

namespace docent::test {
namespace {

constexpr double frame_rate = 120;
constexpr std::uint32_t cycle = 132;   // frames of one stride
constexpr double stance_share = 0.6;   // of a cycle that a foot is on the ground
constexpr double half_width = 0.09;    // metres from the middle to a foot
constexpr double walking_speed = 1.0;  // metres a second
constexpr float hip_height = 0.84f, ankle_height = 0.08f, toe_height = 0.02f;

/// How the body of a clip moves: share of the walking speed, and turning rate, at a frame.
struct WalkedPath {
  const char* name;
  ClipRole role;
  std::uint32_t frames;
  std::function<double(double)> speed;
  double turn;  ///< Radians from first to last frame, spread evenly.
};

std::vector<Placement> body_of(const WalkedPath& walked) {
  std::vector<Placement> body(walked.frames);
  for (std::uint32_t f = 1; f < walked.frames; ++f) {
    const double heading = walked.turn * f / (walked.frames - 1);
    const Vec2 forwards{std::cos(heading), std::sin(heading)};
    const double step = walking_speed * walked.speed(f - 0.5) / frame_rate;
    body[f] = {body[f - 1].position + step * forwards, heading};
  }
  return body;
}

/// Where in its cycle a foot is: from 0, set down, over stance_share, lifted, to 1.
double phase_of(Side side, double frame) {
  const double turn = frame / cycle + (side == Side::Left ? 0.0 : 0.5);
  return turn - std::floor(turn);
}

Placement at(const std::vector<Placement>& body, double frame) {
  const double last = static_cast<double>(body.size() - 1);
  return body[static_cast<std::size_t>(std::clamp(frame, 0.0, last))];
}

/// Where a foot stands that was set down `since` frames before `frame`.
motion::Foot print(const std::vector<Placement>& body, Side side, double frame, double since) {
  const Placement middle = at(body, frame - since + 0.5 * stance_share * cycle);
  const Vec2 place{0.05, side == Side::Left ? half_width : -half_width};
  return {motion::moved(middle, to_world(place, toe_height)),
          motion::world_rotation(middle.heading + std::numbers::pi / 2)};
}

motion::Foot foot_at(const std::vector<Placement>& body, Side side, double frame, bool& planted) {
  const double phase = phase_of(side, frame);
  const motion::Foot last = print(body, side, frame, phase * cycle);
  planted = phase < stance_share;
  if (planted) return last;
  const motion::Foot next = print(body, side, frame, (phase - 1) * cycle);
  const double t = (phase - stance_share) / (1 - stance_share);
  const auto share = static_cast<float>(t * t * (3 - 2 * t));
  motion::Foot foot{glm::mix(last.toe, next.toe, share),
                    glm::slerp(last.rotation, next.rotation, share)};
  planted = glm::distance(last.toe, next.toe) < 0.01f;
  if (!planted) foot.toe.y += 0.08f * static_cast<float>(std::sin(t * std::numbers::pi));
  return foot;
}

MotionClip make_clip(const Skeleton& skeleton, const motion::Legs& legs, const WalkedPath& walked) {
  MotionClip clip;
  clip.name = walked.name;
  clip.role = walked.role;
  clip.motion_class = "walk";
  clip.joint_count = static_cast<std::uint32_t>(skeleton.joint.size());
  const std::vector<Placement> body = body_of(walked);
  for (std::uint32_t f = 0; f < walked.frames; ++f) {
    const double sway = 0.02 * walked.speed(f) * std::sin(2 * std::numbers::pi * f / cycle);
    clip.root.push_back(motion::moved(body[f], to_world({0, sway}, hip_height)));
    clip.rotation.resize(clip.rotation.size() + clip.joint_count, Quat(1, 0, 0, 0));
    motion::PoseView pose{clip.root.back(), std::span(clip.rotation).last(clip.joint_count)};
    pose.rotation[0] = motion::world_rotation(body[f].heading + std::numbers::pi / 2);
    FootPlants plants;
    for (const Side side : both_sides) {
      bool planted = false;
      motion::place_foot(skeleton, legs[side], foot_at(body, side, f, planted), pose);
      (side == Side::Left ? plants.left : plants.right) = planted;
    }
    clip.plants.push_back(plants);
  }
  return clip;
}

/// Joins two clips wherever they are in one phase and both at full speed.
void add_transitions(const std::vector<WalkedPath>& courses, std::uint32_t from, std::uint32_t to,
                     MotionGraph& graph) {
  constexpr std::uint32_t radius = 12, spacing = 11;
  const std::vector<Placement> a = body_of(courses[from]), b = body_of(courses[to]);
  const auto walks = [&](std::uint32_t walked, std::uint32_t frame) {
    return frame >= radius && frame + radius < courses[walked].frames &&
           courses[walked].speed(frame - radius) > 0.999 &&
           courses[walked].speed(frame + radius) > 0.999;
  };
  for (std::uint32_t f = spacing; f < courses[from].frames; f += spacing)
    for (std::uint32_t g = f % cycle; g < courses[to].frames; g += cycle)
      if (walks(from, f) && walks(to, g) && !(from == to && f == g))
        graph.transitions.push_back(
            {{from, f}, {to, g}, radius, 0.01f, motion::compose(a[f], motion::inverse(b[g]))});
}

}  // namespace

Skeleton stick_figure() {
  Skeleton s;
  s.part.fill(JointIndex::None);
  const auto add = [&](BodyPart part, const char* name, BodyPart parent, Vec3 offset) {
    s.part[static_cast<std::size_t>(part)] = static_cast<JointIndex>(s.joint.size());
    s.joint.push_back({name, s.joint.empty() ? JointIndex::None : s[parent], offset});
    s.has_rotation.push_back(true);
  };
  using enum BodyPart;
  add(Hips, "Hips", Hips, {});
  add(Spine, "Spine", Hips, {0, 0.12f, 0});
  add(Chest, "Chest", Spine, {0, 0.2f, 0});
  add(Head, "Head", Chest, {0, 0.25f, 0});
  const auto add_side = [&](float x, BodyPart hip, BodyPart knee, BodyPart ankle, BodyPart toe,
                            BodyPart shoulder, BodyPart elbow, BodyPart wrist, const char* side) {
    const std::string name(side);
    add(hip, (name + "UpLeg").c_str(), Hips, {0.09f * x, -0.02f, 0});
    add(knee, (name + "Leg").c_str(), hip, {0, -0.42f, 0.01f});
    add(ankle, (name + "Foot").c_str(), knee, {0, -0.42f, -0.01f});
    add(toe, (name + "ToeBase").c_str(), ankle, {0, toe_height - ankle_height, 0.14f});
    add(shoulder, (name + "Arm").c_str(), Chest, {0.18f * x, 0.15f, 0});
    add(elbow, (name + "ForeArm").c_str(), shoulder, {0, -0.28f, 0});
    add(wrist, (name + "Hand").c_str(), elbow, {0, -0.26f, 0});
  };
  add_side(1, LeftHip, LeftKnee, LeftAnkle, LeftToe, LeftShoulder, LeftElbow, LeftWrist, "Left");
  add_side(-1, RightHip, RightKnee, RightAnkle, RightToe, RightShoulder, RightElbow, RightWrist,
           "Right");
  return s;
}

MotionGraph hand_made_graph() {
  MotionGraph graph;
  graph.skeleton = stick_figure();
  const motion::Legs legs = *motion::find_legs(graph.skeleton);
  const auto ramp = [](double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  };
  const auto steady = [](double) { return 1.0; };
  const double quarter = std::numbers::pi / 2;
  const std::vector<WalkedPath> courses{
      {"stand-to-walk", ClipRole::Start, 3 * cycle, [=](double f) { return ramp(f / 110 - 0.1); },
       0},
      {"walk", ClipRole::Walk, 4 * cycle, steady, 0},
      {"walk-to-stand", ClipRole::Stop, 3 * cycle, [=](double f) { return ramp(2.2 - f / 110); },
       0},
      {"turn-left", ClipRole::TurnLeft, 3 * cycle, steady, quarter},
      {"turn-right", ClipRole::TurnRight, 3 * cycle, steady, -quarter},
  };
  for (const WalkedPath& walked : courses)
    graph.clips.push_back(make_clip(graph.skeleton, legs, walked));
  for (std::uint32_t from = 0; from < courses.size(); ++from)
    for (std::uint32_t to = 0; to < courses.size(); ++to)
      if (courses[from].role != ClipRole::Stop && courses[to].role != ClipRole::Start)
        add_transitions(courses, from, to, graph);
  std::sort(graph.transitions.begin(), graph.transitions.end(),
            [](const Transition& a, const Transition& b) {
              const auto key = [](const Transition& t) {
                return std::array{t.from.clip, t.from.frame, t.to.clip, t.to.frame};
              };
              return key(a) < key(b);
            });
  return graph;
}

}  // namespace docent::test
