#include "content/compile/compile_touch.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "content/motion/find_touch.h"
#include "content/scenery/furniture.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/motion/walk_graph.h"

namespace docent::compile {
namespace {

using motion::offline::Triangle;

/// Which exhibits have a glass over what they stand in.
std::vector<bool> are_under_glass(const Museum& museum) {
  std::vector<std::vector<scenery::HoleKind>> kinds;
  for (const Floor& floor : museum.floors)
    kinds.push_back(scenery::hole_kinds(floor.plan, museum.exhibits));
  std::vector<bool> are;
  for (const Exhibit& exhibit : museum.exhibits) {
    const FloorPlan& plan = museum.floors[exhibit.floor].plan;
    bool is = false;
    for (std::size_t i = 0; i < plan.ring.size() && exhibit.place == ExhibitPlace::InCase; ++i)
      is |= kinds[exhibit.floor][i] == scenery::HoleKind::Case &&
            contains(scenery::outline_of(plan, plan.ring[i]), exhibit.placement.position);
    are.push_back(is);
  }
  return are;
}

/// Why nobody gets to it with a hand.
std::string why_not(const Museum& museum, std::uint32_t index) {
  constexpr double too_low = 0.6, too_high = 1.7;  // metres
  const Exhibit& exhibit = museum.exhibits[index];
  const double ground = museum.floors[exhibit.floor].plan.height;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const Triangle& triangle : motion::offline::touch_surface(museum, index))
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

std::optional<motion::Stance> standing_body(const Museum& museum) {
  if (museum.motion.clips.empty()) return {};
  auto graph = motion::make_walk_graph(museum.motion);
  if (!graph) return {};
  const motion::Arms arms = motion::find_arms(museum.motion.skeleton);
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

std::vector<Touch> find_touches(const Museum& museum, const motion::Stance& stance,
                                std::uint32_t exhibit, const path::FloorMap& map) {
  constexpr double room = 0.02;  // metres more than the body's radius
  constexpr double narrow = 0.1;
  const Exhibit& it = museum.exhibits[exhibit];
  const motion::Arms arms = motion::find_arms(museum.motion.skeleton);
  const std::vector<Triangle> surface = motion::offline::touch_surface(museum, exhibit);
  const std::vector<Triangle> around = motion::offline::things_around(museum, exhibit);
  const Vec2 view = it.viewing_point.position;
  const motion::offline::TouchSearch search{
      .skeleton = museum.motion.skeleton,
      .arms = arms,
      .stance = stance,
      .surface = surface,
      .around = around,
      .ground = museum.floors[it.floor].plan.height,
      .view = it.viewing_point,
      .middle = it.object >= 0 ? it.stand.position : it.placement.position,
      .has_room = [&](Vec2 at) {
        return map.has_room(at, museum.body_radius + room) &&
               map.walls().capsule_clear(view, at, narrow);
      }};
  std::vector<Touch> touches;
  for (const Side beside : both_sides)
    if (const auto touch = motion::offline::find_touch(search, beside)) touches.push_back(*touch);
  return touches;
}

void compile_touch(const config::MuseumConfig& config, Museum& museum, Report& report) {
  const std::vector<bool> under_glass = are_under_glass(museum);  // by places not yet marked
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
    if (under_glass[i]) {
      tell("it stands under glass", "stand it on a plinth, or leave `touch` out");
      continue;
    }
    if (!stance) stance = standing_body(museum);
    if (stance) {
      const auto [map, is_new] = maps.try_emplace(exhibit.floor, museum.floors[exhibit.floor]);
      exhibit.touches = find_touches(museum, *stance, i, map->second);
      if (exhibit.touches.empty())
        tell(why_not(museum, i),
             "stand it nearer to the edge of what it stands on, or between 0.7 and 1.6 m high, "
             "with room for the guide beside it");
    }
    exhibit.place = hangs(exhibit.place) ? ExhibitPlace::OnWallToTouch : ExhibitPlace::ToTouch;
  }
  // Nobody looks for a glass case and finds a pedestal.
  for (std::size_t i = 0; i < museum.exhibits.size(); ++i)
    if (museum.exhibits[i].place == ExhibitPlace::InCase && !under_glass[i])
      museum.exhibits[i].place = ExhibitPlace::OnFloor;
}

}  // namespace docent::compile
