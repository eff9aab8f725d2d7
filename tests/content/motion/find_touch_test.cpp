#include "content/motion/find_touch.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "content/compile/compile_touch.h"
#include "runtime/motion/gesture.h"
#include "tests/support/sample_as_read.h"

namespace docent::motion::offline::find_touch_test {
namespace {

struct Box {
  Vec3 low{}, high{};
};

/// Counter-clockwise from outside.
std::vector<Triangle> faces_of(const Box& box) {
  const auto corner = [&](unsigned bits) {
    return Vec3((bits & 4U) != 0 ? box.high.x : box.low.x,
                (bits & 2U) != 0 ? box.high.y : box.low.y,
                (bits & 1U) != 0 ? box.high.z : box.low.z);
  };
  std::vector<Triangle> faces;
  for (const auto& [a, b, c, d] : std::to_array<std::array<unsigned, 4>>(
           {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})) {
    faces.push_back({corner(a), corner(b), corner(c)});
    faces.push_back({corner(a), corner(c), corner(d)});
  }
  return faces;
}

float depth_in(const Box& box, Vec3 point) {
  const Vec3 in = glm::min(point - box.low, box.high - point);
  return std::min({in.x, in.y, in.z});
}

/// Whatever stands on a plinth of any height: either there is no touch, or the hand of somebody who
/// stands clear of the plinth is on the surface, and their arm nowhere in it.
RC_GTEST_PROP(FindTouch, ReachesTheSurfaceOrSaysThatItDoesNot, ()) {
  const Museum& museum = test::sample_museum();
  static const Stance stance = compile::standing_body(museum).value();
  static const Arms arms = find_arms(museum.motion.skeleton);
  const auto metres = [](int least, int most) {
    return static_cast<float>(*rc::gen::inRange(least, most)) / 100;
  };
  const float wide = metres(8, 90), high = metres(5, 160), deep = metres(8, 90);
  const float base = metres(0, 180);
  const float half = std::max(wide, deep) / 2 + metres(2, 40);
  const Box block = {{-wide / 2, base, -deep / 2}, {wide / 2, base + high, deep / 2}};
  const Box plinth = {{-half, 0, -half}, {half, base, half}};
  const std::vector<Triangle> surface = faces_of(block), around = faces_of(plinth);
  const auto has_room = [&](Vec2 at) {
    const Vec2 limit{half, half};
    return glm::distance(at, glm::clamp(at, -limit, limit)) > museum.body_radius;
  };
  const TouchSearch search{.skeleton = museum.motion.skeleton,
                           .arms = arms,
                           .stance = stance,
                           .surface = surface,
                           .around = around,
                           .ground = 0,
                           .view = {{-2.5, 0}, 0},
                           .middle = {},
                           .has_room = has_room};
  for (const Side side : both_sides) {
    const auto touch = find_touch(search, side);
    const bool is_easy = base + high > 1.0F && base < 1.1F &&
                         half - std::max(wide, deep) / 2 < 0.1F &&
                         std::min(wide, deep) > 0.7F * std::max(wide, deep);
    if (is_easy) RC_ASSERT(touch.has_value());
    RC_CLASSIFY(touch.has_value());
    if (!touch) continue;
    RC_ASSERT(has_room(touch->body.position));
    RC_ASSERT(touch->beside == side);
    const Arm& arm = *arms[touch->hand];
    const Stance stands = moved_to(stance, touch->body, 0);
    for (double at = longest_change; at < touch_seconds; at += 0.05) {
      const JointPlace trunk = leaned(stands, lean_after(*touch, at)).trunk[index_of(touch->hand)];
      const ArmPosture posture =
          holding(museum.motion.skeleton, arm, trunk, grip_after(*touch, at));
      const ArmPlaces held = places_of(museum.motion.skeleton, arm, trunk, posture);
      const bool rests = at >= touch_begins && at <= touch_ends;
      if (rests) RC_ASSERT(distance_to(surface, held.palm) < touches_within);
      constexpr float grazes = 0.004F;  // metres, between the moments that were looked at
      for (float part = 0; part <= 1; part += 0.125F)
        for (const Vec3 p :
             {glm::mix(held.shoulder, held.elbow, part), glm::mix(held.elbow, held.wrist, part),
              glm::mix(held.wrist, held.tip, part)}) {
          RC_ASSERT(depth_in(block, p) < grazes);
          RC_ASSERT(depth_in(plinth, p) < grazes);
        }
    }
  }
}

}  // namespace
}  // namespace docent::motion::offline::find_touch_test
