#include "content/motion/find_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/motion/gesture.h"

namespace docent::motion::offline {
namespace {

constexpr float lowest = 0.55F, highest = 1.75F;  ///< Metres above the ground.
constexpr float before_body =
    0.24F;  ///< Metres ahead of the body: there is nothing in a hand's way.
constexpr float build_least = 0.94F, build_most = 1.05F;  ///< Of bodies (scene/look.h).
constexpr float presses = 0.004F;          ///< Metres by which a palm may miss its place...
constexpr float presses_swaying = 0.006F;  ///< ... and while the body sways.

Vec3 heading_vector(double heading) noexcept {
  return to_world({std::cos(heading), std::sin(heading)});
}

double direction_of(Vec2 line) noexcept {
  return std::atan2(line.y, line.x);
}

Vec3 nearest_of(const Triangle& t, Vec3 p) noexcept {
  // Ericson, Real-Time Collision Detection (2005), 5.1.5.
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const Vec3 bp = p - t[1];
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - t[2];
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]);
  const float sum = va + vb + vc;
  if (sum <= 0) return t[0];
  return t[0] + vb / sum * ab + vc / sum * ac;
}

/// Moller and Trumbore 1997.
bool goes_through(const Triangle& t, Vec3 from, Vec3 to) noexcept {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], along = to - from;
  const Vec3 p = glm::cross(along, ac);
  const float det = glm::dot(ab, p);
  if (std::abs(det) < 1e-12F) return false;
  const Vec3 s = from - t[0];
  const float u = glm::dot(s, p) / det;
  if (u < 0 || u > 1) return false;
  const Vec3 q = glm::cross(s, ab);
  const float v = glm::dot(along, q) / det, at = glm::dot(ac, q) / det;
  return v >= 0 && u + v <= 1 && at >= 0 && at <= 1;
}

/// A point of the surface that a palm might lie on.
struct Spot {
  Vec3 place{}, normal{};
};

/// Points all over the surface, some 8 cm apart, at heights that a hand gets to.
std::vector<Spot> spots_of(const TouchSearch& search) {
  constexpr float apart = 0.08F;
  constexpr int most = 16;
  const auto ground = static_cast<float>(search.ground);
  std::vector<Spot> spots;
  for (const Triangle& t : search.surface) {
    const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const float area = glm::length(normal);
    if (area < 1e-8F) continue;
    const float longest =
        std::max({glm::distance(t[0], t[1]), glm::distance(t[1], t[2]), glm::distance(t[2], t[0])});
    const int n = std::clamp(static_cast<int>(std::ceil(longest / apart)), 1, most);
    const auto parts = static_cast<float>(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const float u = (static_cast<float>(i) + 1.0F / 3) / parts;
        const float v = (static_cast<float>(j) + 1.0F / 3) / parts;
        const Vec3 place = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
        if (place.y - ground > lowest && place.y - ground < highest)
          spots.push_back({place, normal / area});
      }
  }
  return spots;
}

/// Where one can stand beside it, as near as there is room: not in the line of sight, and not
/// behind it.
std::vector<Vec2> places_beside(const TouchSearch& search, Side beside) {
  constexpr int turns = 36;
  constexpr double nearest = 0.2, farthest = 1.8, step = 0.04;
  constexpr double aside = 0.3;    // metres from the line of sight
  constexpr double behind = -0.1;  // cosine of the angle at it to the visitor
  const Vec2 line = search.middle - search.view.position;
  const double length = glm::length(line);
  const Vec2 on = length > 0.05
                      ? line / length
                      : Vec2{std::cos(search.view.heading), std::sin(search.view.heading)};
  std::vector<Vec2> places;
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = 2 * std::numbers::pi * turn / turns;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    if (dot(out, -on) < behind) continue;
    for (double off = nearest; off < farthest; off += step) {
      const Vec2 at = search.middle + off * out;
      if (!search.has_room(at)) continue;
      if (sign_of(beside) * static_cast<float>(cross(on, at - search.view.position)) > aside)
        places.push_back(at);
      break;
    }
  }
  return places;
}

/// A way to touch it that might do.
struct Try {
  float cost = 0;
  Vec2 stands{};
  Side side = Side::Right;
  Spot spot;
};

std::vector<Try> tries_of(const TouchSearch& search, Side beside) {
  constexpr float reach = 1.2F, comfortable = 0.75F;  // of the arm; leaning helps
  constexpr float comfortable_height = 1.1F;
  constexpr float squarely = 0.3F;  // cosine
  std::vector<Try> found;
  const std::vector<Spot> spots = spots_of(search);
  for (const Vec2 stands : places_beside(search, beside))
    for (const Side side : both_sides) {
      if (!search.arms[side]) continue;
      const Arm& arm = *search.arms[side];
      const float length = arm.upper + arm.fore + 0.5F * arm.hand;
      const Placement faces{stands, direction_of(search.middle - stands)};
      const Stance stance = moved_to(search.stance, faces, search.ground);
      const ArmPlaces hangs = places_of(search.skeleton, arm, stance.trunk[index_of(side)], {});
      for (const Spot& spot : spots) {
        const Vec3 line = hangs.shoulder - spot.place;
        const float far = glm::length(line);
        const float towards = far > 0 ? glm::dot(line, spot.normal) / far : 0;
        const float square = std::abs(towards);  // files have faces inside out
        if (far > reach * length || square < squarely) continue;
        const float height = spot.place.y - static_cast<float>(search.ground);
        found.push_back({2 * std::abs(far / length - comfortable) +
                             0.6F * std::abs(height - comfortable_height) + 0.7F * (1 - square),
                         stands,
                         side,
                         {spot.place, towards < 0 ? -spot.normal : spot.normal}});
      }
    }
  std::ranges::stable_sort(found, {}, &Try::cost);
  return found;
}

/// Does an arm that holds so go through any of them?
bool is_inside(std::span<const Triangle> surface, const ArmPlaces& arm) noexcept {
  return std::ranges::any_of(surface, [&](const Triangle& t) {
    return goes_through(t, arm.shoulder, arm.elbow) || goes_through(t, arm.elbow, arm.wrist) ||
           goes_through(t, arm.wrist, arm.palm) || goes_through(t, arm.palm, arm.tip);
  });
}

/// The same for what it does not touch: below an arm's bones there is flesh.
bool is_inside_others(std::span<const Triangle> around, const ArmPlaces& arm) noexcept {
  constexpr float flesh = 0.025F;
  const Vec3 down{0, flesh, 0};
  ArmPlaces below = arm;
  below.elbow -= down;
  below.wrist -= down;
  return is_inside(around, arm) || is_inside(around, below);
}

Vec3 ready_for(const Stance& stance, Vec3 shoulder, Vec3 palm) noexcept {
  constexpr float least_height = 0.98F, raised = 0.05F;
  const Vec3 ahead = heading_vector(stance.body.heading);
  const Vec3 body = to_world(stance.body.position, stance.height);
  Vec3 ready = shoulder + (before_body - glm::dot(shoulder - body, ahead)) * ahead;
  const auto ground = static_cast<float>(stance.height);
  ready.y = std::max(palm.y + raised, ground + least_height);
  return ready;
}

/// How far a palm is from its grip, held from a trunk that is off by so much.
float miss(const TouchSearch& search, const Arm& arm, JointPlace trunk, const Grip& grip, Vec3 off,
           float yaw) noexcept {
  trunk.place += off;
  trunk.rotation = glm::angleAxis(yaw, Vec3(0, 1, 0)) * trunk.rotation;
  const ArmPosture posture = holding(search.skeleton, arm, trunk, grip);
  return glm::distance(palm_of(search.skeleton, arm, trunk, posture), grip.place);
}

/// Does the palm get there whoever it is, and though they breathe and shift their weight?
bool reaches(const TouchSearch& search, const Arm& arm, const Stance& stance, const Grip& grip) {
  constexpr float sway = 0.03F, turn = 0.1F;
  const JointPlace& trunk = stance.trunk[index_of(arm.side)];
  if (miss(search, arm, trunk, grip, {}, 0) > presses) return false;
  const Vec3 ahead = heading_vector(stance.body.heading);
  const Vec3 aside = glm::cross(ahead, Vec3(0, 1, 0));
  const auto ground = static_cast<float>(stance.height);
  for (const float build : {build_least, build_most}) {
    Grip theirs = grip;
    theirs.place.y = ground + (grip.place.y - ground) / build;
    for (const float sign : {-1.0F, 1.0F})
      if (miss(search, arm, trunk, theirs, sign * sway * aside - 0.01F * ahead, sign * turn) >
          presses_swaying)
        return false;
  }
  return true;
}

/// Are trunk and head of somebody who leans so out of all that is there?
bool is_body_free(const TouchSearch& search, const Stance& stance) noexcept {
  const JointPlace& trunk = stance.trunk[0];
  const Vec3 face = trunk.place + trunk.rotation * Vec3(0, 0.4F, 0.14F);
  const auto is_free = [&](const Triangle& t) {
    return !goes_through(t, stance.waist, face) && !goes_through(t, trunk.place, face);
  };
  return std::ranges::all_of(search.surface, is_free) &&
         std::ranges::all_of(search.around, is_free);
}

bool is_free_all_the_way(const TouchSearch& search, const Arm& arm, const Stance& stance,
                         const Touch& touch) {
  constexpr int looks = 6;
  for (int i = 0; i <= looks; ++i) {
    const double at = longest_change + (touch_begins - longest_change) * i / looks;
    const JointPlace trunk = leaned(stance, lean_after(touch, at)).trunk[index_of(arm.side)];
    const ArmPosture posture = holding(search.skeleton, arm, trunk, grip_after(touch, at));
    const ArmPlaces held = places_of(search.skeleton, arm, trunk, posture);
    if (is_inside(search.surface, held) || is_inside_others(search.around, held)) return false;
  }
  return true;
}

/// The hand on that spot, turned as it lies best, from a trunk that leans so.
std::optional<Touch> lay_on(const TouchSearch& search, const Try& it, const Stance& upright,
                            float lean) {
  constexpr float faces_it = 0.8F;    // cosine
  constexpr float most_bent = 0.95F;  // radians, of a wrist that rests
  const Arm& arm = *search.arms[it.side];
  const Stance stance = leaned(upright, lean);
  const JointPlace& trunk = stance.trunk[index_of(it.side)];
  const Vec3 n = it.spot.normal;
  const Vec3 ahead = heading_vector(direction_of(to_floor(it.spot.place) - it.stands));
  const Vec3 inwards = sign_of(it.side) * glm::cross(ahead, Vec3(0, 1, 0));
  const Vec3 up{0, 1, 0};
  if (!is_body_free(search, stance)) return {};
  for (const Vec3 wish : {up + 0.7F * ahead + 0.5F * inwards, up + inwards, ahead + 0.3F * inwards,
                          inwards + 0.3F * ahead, up}) {
    const Vec3 square = wish - n * glm::dot(wish, n);
    if (glm::length(square) < 0.2F) continue;
    Touch touch{.hand = it.side,
                .body = stance.body,
                .palm = it.spot.place + half_a_palm * n,
                .fingers = glm::normalize(square),
                .normal = n,
                .lean = lean};
    touch.thumb = thumb_of(it.side, touch.fingers, -n);
    const Grip grip = grip_of(touch);
    const ArmPosture posture = holding(search.skeleton, arm, trunk, grip);
    const ArmPlaces held = places_of(search.skeleton, arm, trunk, posture);
    if (std::hypot(posture.wrist_flexion, posture.wrist_deviation) > most_bent ||
        glm::distance(held.palm, grip.place) > presses || glm::dot(held.faces, -n) < faces_it)
      continue;
    touch.ready = ready_for(stance, held.shoulder, grip.place);
    if (reaches(search, arm, stance, grip) && is_free_all_the_way(search, arm, upright, touch))
      return touch;
  }
  return {};
}

/// Leaning no further than is needed.
std::optional<Touch> lay_on(const TouchSearch& search, const Try& it) {
  constexpr double leads = 0.25;  // radians by which the shoulder leads
  const double straight = direction_of(to_floor(it.spot.place) - it.stands);
  const Placement body{it.stands, straight + (it.side == Side::Right ? leads : -leads)};
  const Stance upright = moved_to(search.stance, body, search.ground);
  for (const float lean : {0.0F, 0.12F, 0.22F, Touch::most_lean})
    if (const std::optional<Touch> touch = lay_on(search, it, upright, lean)) return touch;
  return {};
}

/// A box along the axes; nothing where low is above high.
struct Extent {
  Vec3 low{std::numeric_limits<float>::max()}, high{-std::numeric_limits<float>::max()};
};

Extent extent_of(std::span<const Triangle> triangles) noexcept {
  Extent all;
  for (const Triangle& t : triangles)
    for (const Vec3 corner : t) {
      all.low = glm::min(all.low, corner);
      all.high = glm::max(all.high, corner);
    }
  return all;
}

Extent grown(const Extent& box, float by) noexcept {
  return {box.low - by, box.high + by};
}

bool overlap(const Extent& a, const Extent& b) noexcept {
  return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

/// Adds what is drawn of the exhibits that `is_meant`; -1 is the building.
void add_scenery(const Scenery& scenery, const std::function<bool(std::int32_t)>& is_meant,
                 std::vector<Triangle>& all) {
  for (const SceneryPart& part : scenery.parts) {
    if (!is_meant(part.exhibit)) continue;
    for (std::uint32_t i = 0; i + 2 < part.index_count; i += 3) {
      const auto corner = [&](std::uint32_t k) {
        return scenery.vertices[scenery.indices[part.first_index + i + k]].position;
      };
      all.push_back({corner(0), corner(1), corner(2)});
    }
  }
}

/// Adds an exhibit's own shape, where it has one.
void add_object(const Museum& museum, std::uint32_t exhibit, std::vector<Triangle>& all) {
  const Exhibit& it = museum.exhibits[exhibit];
  if (it.object < 0 || it.floor >= museum.floors.size()) return;
  const ExhibitObject& object = museum.objects[static_cast<std::size_t>(it.object)];
  const auto scale = static_cast<float>(it.stand.scale);
  // Its front, +z, looks where the exhibit does.
  const Quat turned = glm::angleAxis(
      static_cast<float>(it.placement.heading) + std::numbers::pi_v<float> / 2, Vec3(0, 1, 0));
  const Vec3 foot =
      to_world(it.stand.position, museum.floors[it.floor].plan.height + it.stand.base);
  const Vec3 low{-object.size.x / 2, 0, -object.size.z / 2};
  const auto place = [&](std::uint16_t index) {
    const auto& p = object.distant.vertices[index].position;
    const Vec3 share = Vec3(p[0], p[1], p[2]) / 65535.0F;
    return foot + turned * (scale * (low + share * object.size));
  };
  const std::vector<std::uint16_t>& index = object.distant.triangles;
  for (std::size_t i = 0; i + 2 < index.size(); i += 3)
    all.push_back({place(index[i]), place(index[i + 1]), place(index[i + 2])});
}

}  // namespace

std::vector<Triangle> touch_surface(const Museum& museum, std::uint32_t exhibit) {
  std::vector<Triangle> surface;
  const Exhibit& it = museum.exhibits[exhibit];
  if (it.floor < museum.scenery.size())
    add_scenery(
        museum.scenery[it.floor],
        [&](std::int32_t of) { return of == static_cast<std::int32_t>(exhibit); }, surface);
  add_object(museum, exhibit, surface);
  return surface;
}

std::vector<Triangle> things_around(const Museum& museum, std::uint32_t exhibit) {
  constexpr float arms_length = 1, above_ground = 0.1F;  // metres
  const Extent near = grown(extent_of(touch_surface(museum, exhibit)), arms_length);
  std::vector<Triangle> all;
  const Exhibit& it = museum.exhibits[exhibit];
  if (it.floor >= museum.scenery.size()) return all;
  add_scenery(
      museum.scenery[it.floor],
      [&](std::int32_t of) { return of != static_cast<std::int32_t>(exhibit); }, all);
  for (std::uint32_t other = 0; other < museum.exhibits.size(); ++other)
    if (other != exhibit && museum.exhibits[other].floor == it.floor)
      add_object(museum, other, all);
  const auto ground = static_cast<float>(museum.floors[it.floor].plan.height) + above_ground;
  std::erase_if(all, [&](const Triangle& t) {
    const Extent its = extent_of({&t, 1});
    return its.high.y < ground || !overlap(its, near);
  });
  return all;
}

float distance_to(std::span<const Triangle> surface, Vec3 point) noexcept {
  float least = std::numeric_limits<float>::infinity();
  for (const Triangle& t : surface)
    least = std::min(least, glm::distance(nearest_of(t, point), point));
  return least;
}

std::optional<Touch> find_touch(const TouchSearch& search, Side beside) {
  constexpr std::size_t most = 1500;
  const std::vector<Try> sorted = tries_of(search, beside);
  for (std::size_t i = 0; i < std::min(most, sorted.size()); ++i)
    if (std::optional<Touch> touch = lay_on(search, sorted[i])) {
      touch->beside = beside;
      return touch;
    }
  return {};
}

}  // namespace docent::motion::offline
