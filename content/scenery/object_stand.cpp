#include "content/scenery/object_stand.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/geometry/polygon.h"

namespace docent::scenery {
namespace {

/// Metres above the floor that nothing is higher than: cameras look over it.
constexpr double highest = 2.3;
/// From the top of what it stands on, so that the two faces are told apart.
constexpr double above = 0.004;

/// How far it is from a point within a convex outline to its nearest side; 0 outside.
double room_about(const Outline& outline, Vec2 p) {
  double least = 1e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], side = outline[(i + 1) % outline.size()] - a;
    const double length = std::hypot(side.x, side.y);
    if (length > 0) least = std::min(least, cross(side, p - a) / length);
  }
  return std::max(least, 0.0);
}

Vec2 middle_of(const Outline& outline) {
  Vec2 middle{};
  for (const Vec2 p : outline) middle += p / static_cast<double>(outline.size());
  return middle;
}

/// An object that turns about its middle needs a circle.
double reach_of(Vec3 size) {
  return std::hypot(size.x, size.z) / 2;
}

double scale_for(double room, double needs) {
  return needs > room && needs > 0 ? room / needs : 1;
}

/// Objects are looked at from above: small ones are lifted up, large ones stand on the floor.
double plinth_for(double height) {
  constexpr double small = 0.6, large = 1.1;
  constexpr double high = 0.9, low = 0.36, base = 0.03;
  return height < small ? high : height < large ? low : base;
}

}  // namespace

PlacedObject place_object(const ExhibitStand& stand, Vec3 size) {
  PlacedObject placed;
  ObjectStand& it = placed.stand;
  it.position = stand.placement.position;
  double room = 0, top = highest;
  if (stand.hole != nullptr) {
    const bool in_glass = stand.on == HoleKind::Case;
    const Outline inner = inset(*stand.hole, in_glass ? 0.08 : 0.02);
    it.base = top_of(stand.on, *stand.hole) + above;
    room = room_about(inner, it.position);
    // Where its place is at the edge and it is alone there, it moves towards the middle.
    if (const Vec2 to_middle = middle_of(inner) - it.position; room < reach_of(size)) {
      const double length = std::hypot(to_middle.x, to_middle.y);
      const double most = room_about(inner, middle_of(inner));
      const double step = std::min(length, std::max(0.0, std::min(reach_of(size), most) - room));
      if (length > 0 && contains(inner, middle_of(inner)))
        it.position += to_middle * (step / length);
      room = std::max(room_about(inner, it.position), 0.02);
    }
    if (in_glass) top = glass_top - 0.05;
  } else {
    const double rim = 0.02;
    const double half = stand.taken.x > 0 && stand.taken.y > 0
                            ? std::min(stand.taken.x, stand.taken.y) / 2
                            : reach_of(size) + 0.06;
    const double scale = scale_for(half - rim, reach_of(size));
    placed.plinth_height = plinth_for(scale * size.y);
    const Vec2 plinth =
        stand.taken.x > 0 && stand.taken.y > 0 ? 0.5 * stand.taken : Vec2{half, half};
    placed.plinth = rectangle(it.position, stand.placement.heading, plinth);
    it.base = placed.plinth_height + above;
    room = half - rim;
  }
  it.scale = std::min(scale_for(room, reach_of(size)), scale_for(top - it.base, size.y));
  // The shade of the whole box would be too much of it.
  constexpr double shades = 0.8;
  placed.shade = {rectangle(it.position, stand.placement.heading,
                            shades * it.scale * Vec2{size.x, size.z} / 2.0),
                  it.base + shades * it.scale * size.y};
  return placed;
}

}  // namespace docent::scenery
