#include "tests/content/motion/random_graph.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace docent::test {
namespace {

MotionClip bent_clip(std::uint32_t frames, double bend, ClipRole role) {
  MotionClip clip;
  clip.role = role;
  clip.joint_count = 1;
  Vec2 place{};
  for (std::uint32_t f = 0; f < frames; ++f) {
    const double heading = bend * f;
    clip.root.push_back(to_world(place, 1));
    clip.rotation.push_back(glm::angleAxis(static_cast<float>(heading), Vec3(0, 1, 0)));
    clip.plants.push_back({});
    place += 0.01 * Vec2{std::cos(heading), std::sin(heading)};
  }
  return clip;
}

/// Lays the frame `to` of one clip onto the frame `from` of another.
Placement alignment_of(const MotionClip& a, std::uint32_t from, double bend_a, const MotionClip& b,
                       std::uint32_t to, double bend_b) {
  const double turn = bend_a * from - bend_b * to;
  const Vec2 p = to_floor(b.root[to]);
  const double c = std::cos(turn), s = std::sin(turn);
  return {to_floor(a.root[from]) - Vec2{c * p.x - s * p.y, s * p.x + c * p.y}, turn};
}

}  // namespace

rc::Gen<MotionGraph> random_graph() {
  return rc::gen::exec([] {
    MotionGraph graph;
    std::vector<double> bend;
    const auto clips = *rc::gen::inRange<std::uint32_t>(3, 6);
    for (std::uint32_t c = 0; c < clips; ++c) {
      bend.push_back(0.001 * *rc::gen::inRange(-20, 21));
      const ClipRole role = c == 0 ? ClipRole::Start : c == 1 ? ClipRole::Stop : ClipRole::Walk;
      graph.clips.push_back(bent_clip(*rc::gen::inRange<std::uint32_t>(20, 60), bend.back(), role));
    }
    const auto transitions = *rc::gen::inRange<std::uint32_t>(3, 16);
    for (std::uint32_t i = 0; i < transitions; ++i) {
      const auto radius = *rc::gen::inRange<std::uint32_t>(1, 9);
      const auto middle = [&](std::uint32_t clip) {
        const auto frames = static_cast<std::uint32_t>(graph.clips[clip].root.size());
        return ClipFrame{clip, *rc::gen::inRange(radius, frames - radius)};
      };
      const ClipFrame from = middle(*rc::gen::inRange<std::uint32_t>(0, clips));
      const ClipFrame to = middle(*rc::gen::inRange<std::uint32_t>(0, clips));
      graph.transitions.push_back(
          {.from = from,
           .to = to,
           .radius = radius,
           .distance = 0.01f,
           .alignment = alignment_of(graph.clips[from.clip], from.frame, bend[from.clip],
                                     graph.clips[to.clip], to.frame, bend[to.clip])});
    }
    std::ranges::sort(graph.transitions, {}, [](const Transition& t) {
      return std::tuple(t.from.clip, t.from.frame, t.to.clip, t.to.frame, t.radius);
    });
    return graph;
  });
}

}  // namespace docent::test
