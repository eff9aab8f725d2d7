#include "content/compile/compile_touch.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "content/scenery/furniture.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/motion/touch.h"
#include "runtime/motion/walk_graph.h"
#include "runtime/path/floor_map.h"

namespace docent::compile {
namespace {

/// Somebody who stands at the floor's origin; none without clips.
std::optional<motion::Stance> stance_of(const Museum& museum, const motion::Arms& arms) {
  if (museum.motion.clips.empty()) return {};
  auto graph = motion::make_walk_graph(museum.motion);
  if (!graph) return {};
  motion::Stand& stand = graph->before_walking;
  const motion::PoseView pose{.root = stand.root, .rotation = stand.rotation};
  motion::Stance stance;
  for (const Side side : both_sides)
    if (arms[side])
      stance.trunk[index_of(side)] =
          motion::place_of(museum.motion.skeleton, arms[side]->trunk, pose);
  const JointIndex spine = museum.motion.skeleton[BodyPart::Spine];
  if (spine != JointIndex::None)
    stance.waist = motion::place_of(museum.motion.skeleton, spine, pose).place;
  return stance;
}

/// Has what it stands in a glass over it?
bool is_under_glass(const Museum& museum, const Exhibit& exhibit) {
  if (exhibit.place != ExhibitPlace::InCase) return false;
  const FloorPlan& plan = museum.floors[exhibit.floor].plan;
  const std::vector<scenery::HoleKind> kinds = scenery::hole_kinds(plan, museum.exhibits);
  for (std::size_t i = 0; i < plan.ring.size(); ++i)
    if (kinds[i] == scenery::HoleKind::Case &&
        contains(scenery::outline_of(plan, plan.ring[i]), exhibit.placement.position))
      return true;
  return false;
}

/// Why nobody gets to it with a hand.
std::string why_not(const Museum& museum, std::uint32_t index) {
  constexpr double too_low = 0.6, too_high = 1.7;  // metres
  const Exhibit& exhibit = museum.exhibits[index];
  const double ground = museum.floors[exhibit.floor].plan.height;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const motion::Triangle& triangle : motion::touch_surface(museum, index))
    for (const Vec3 corner : triangle) {
      low = std::min(low, static_cast<double>(corner.y) - ground);
      high = std::max(high, static_cast<double>(corner.y) - ground);
    }
  if (high < low) return "nothing of it is drawn";
  if (high < too_low) return fmt::format("its top is only {:.2f} m above the floor", high);
  if (low > too_high) return fmt::format("it begins {:.2f} m above the floor", low);
  return fmt::format(
      "from where the guide, {:.2f} m wide, can stand beside it, its arm is too short",
      2 * museum.body_radius);
}

}  // namespace

void compile_touch(const config::MuseumConfig& config, Museum& museum, Report& report) {
  const motion::Arms arms = motion::find_arms(museum.motion.skeleton);
  std::optional<motion::Stance> stance;
  std::map<std::uint32_t, path::FloorMap> maps;
  for (std::uint32_t i = 0; i < config.exhibits.size() && i < museum.exhibits.size(); ++i) {
    const config::ExhibitSection& section = config.exhibits[i];
    if (!section.touch.value) continue;
    Exhibit& exhibit = museum.exhibits[i];
    const auto tell = [&](const std::string& why, std::string hint) {
      Diagnostic diagnostic = config::diagnostic_at(
          config, section.touch.place, "touch-out-of-reach",
          fmt::format("the guide does not touch exhibit '{}', and points at it: {}", exhibit.id,
                      why),
          {}, std::move(hint));
      diagnostic.severity = Severity::Warning;
      report.add(std::move(diagnostic));
    };
    if (is_under_glass(museum, exhibit)) {
      tell("it stands under glass", "stand it on a plinth, or leave `touch` out");
      continue;
    }
    if (!stance) stance = stance_of(museum, arms);
    if (stance) {
      const auto [map, is_new] = maps.try_emplace(exhibit.floor, museum.floors[exhibit.floor]);
      const bool is_reached = std::ranges::any_of(both_sides, [&](Side side) {
        return motion::find_touch(museum, arms, *stance, i, map->second, side).has_value();
      });
      if (!is_reached) {
        tell(why_not(museum, i),
             "stand it nearer to the edge of what it stands on, or between 0.7 and 1.6 m high, "
             "with room for the guide beside it");
        continue;
      }
    }
    exhibit.place = hangs(exhibit.place) ? ExhibitPlace::OnWallToTouch : ExhibitPlace::ToTouch;
  }
}

}  // namespace docent::compile
