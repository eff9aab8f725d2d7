#include "content/scenery/scenery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "content/scenery/baked_light.h"
#include "content/scenery/flight.h"
#include "content/scenery/furniture.h"
#include "content/scenery/lift_car.h"
#include "content/scenery/mesh_builder.h"
#include "content/scenery/object_stand.h"
#include "content/scenery/plates.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::scenery {
namespace {

constexpr double wall_thickness = 0.4;
/// How far the table round the building is drawn; it holds the building's shadow.
constexpr double ground_margin = 3.2;

struct Bounds {
  Vec2 low{1e30, 1e30}, high{-1e30, -1e30};
};

Bounds bounds_of(std::span<const Vec2> points) {
  Bounds b;
  for (const Vec2 p : points) {
    b.low = glm::min(b.low, p);
    b.high = glm::max(b.high, p);
  }
  return b;
}

HeightField make_field(const FloorPlan& plan, double texel) {
  const Bounds b = bounds_of(plan.vertex);
  const Vec2 margin(ground_margin + wall_thickness);
  const Vec2 size = b.high - b.low + 2.0 * margin;
  constexpr double longest = 2000;  // texels a side
  return {b.low - margin, b.high + margin, std::max(texel, std::max(size.x, size.y) / longest)};
}

/// The floor goes on under what stands on it, which leaves a gap at its foot.
Surface surface_of(const Plate& plate, std::span<const PavedArea> paving) {
  if (plate.region == PlateKind::Wall) return Surface::CutFace;
  if (plate.area > 0 && paving[plate.area - 1].paving == Paving::Stone) return Surface::Stone;
  return Surface::Floor;
}

void build_plates(const Plates& plates, std::span<const PavedArea> paving,
                  const std::vector<Outline>& openings, MeshBuilder& mesh, HeightField& field) {
  constexpr Vec3 up{0, 1, 0};
  const auto is_open = [&](const Plate& plate) {
    const Vec2 middle = (plate.corner[0] + plate.corner[1] + plate.corner[2]) / 3.0;
    return plate.region == PlateKind::Hole &&
           std::ranges::any_of(openings, [&](const Outline& o) { return contains(o, middle); });
  };
  for (const Plate& plate : plates.plates) {
    if (is_open(plate)) continue;
    const double height = plate.region == PlateKind::Wall ? cut_height : 0;
    mesh.use(surface_of(plate, paving));
    if (plate.area > 0) mesh.floor_tint(paving[plate.area - 1].tint);
    mesh.triangle({to_world(plate.corner[0], height), to_world(plate.corner[1], height),
                   to_world(plate.corner[2], height)},
                  up);
    if (plate.region == PlateKind::Wall) field.raise(plate.corner, height);
  }
  constexpr std::array rows{0.0, 0.1, 0.3, 0.7, cut_height};
  mesh.use(Surface::Plaster);
  for (const WallEdge& edge : plates.wall_edges) mesh.wall(edge.a, edge.b, rows);
}

/// What of some boxes lies outside of another.
std::vector<Bounds> without(const std::vector<Bounds>& boxes, const Bounds& hole) {
  std::vector<Bounds> rest;
  const auto keep = [&](Vec2 low, Vec2 high) {
    if (low.x < high.x && low.y < high.y) rest.push_back({low, high});
  };
  for (const Bounds& box : boxes) {
    const Vec2 low = glm::clamp(hole.low, box.low, box.high);
    const Vec2 high = glm::clamp(hole.high, box.low, box.high);
    keep(box.low, {box.high.x, low.y});
    keep({box.low.x, high.y}, box.high);
    keep({box.low.x, low.y}, {low.x, high.y});
    keep({high.x, low.y}, {box.high.x, high.y});
  }
  return rest;
}

/// The table on which the model stands. Where the floor is open, it is too.
void build_ground(const HeightField& field, const std::vector<Outline>& openings,
                  MeshBuilder& mesh) {
  constexpr double below = -0.01;
  std::vector<Bounds> boxes{{field.low(), field.high()}};
  for (const Outline& opening : openings) boxes = without(boxes, bounds_of(opening));
  mesh.use(Surface::Ground);
  for (const auto& [low, high] : boxes)
    mesh.quad({to_world(low, below), to_world({high.x, low.y}, below), to_world(high, below),
               to_world({low.x, high.y}, below)});
}

/// The flights of a floor, each in a hole of its own, which becomes one of that kind.
std::vector<Flight> flights_of(const FloorPlan& plan, const std::vector<Passage>& passages,
                               std::vector<HoleKind>& kinds) {
  std::vector<Flight> flights;
  for (const Passage& passage : passages) {
    const std::optional<Flight> flight = flight_of(plan, passage);
    if (!flight || kinds[flight->ring] == HoleKind::Flight) continue;
    kinds[flight->ring] = HoleKind::Flight;
    flights.push_back(*flight);
  }
  return flights;
}

std::vector<Outline> openings_of(const std::vector<Flight>& flights) {
  std::vector<Outline> openings;
  for (const Flight& flight : flights)
    if (flight.passage.rise < 0) openings.push_back(flight.footprint);
  return openings;
}

/// The hole that an exhibit stands in, or null.
const Outline* hole_under(const std::vector<Outline>& holes, const std::vector<HoleKind>& kinds,
                          Vec2 p, HoleKind& kind) {
  for (std::size_t r = 0; r < holes.size(); ++r) {
    if (kinds[r] == HoleKind::Wall || kinds[r] == HoleKind::Flight || !contains(holes[r], p))
      continue;
    kind = kinds[r];
    return &holes[r];
  }
  return nullptr;
}

/// The light of the part of a lid whose light a vertex keeps: the mean of what lies about it and is
/// as high. The edge of a shadow is narrower than the mesh is fine, and would have teeth; a vertex
/// under a board or a thing would be dark, and the lid would have a star there.
Light light_about(const HeightField& field, const Sun& sun, Vec2 point, double height,
                  Vec3 normal) {
  constexpr double same = 0.02, above = 0.01;
  constexpr std::array rings{0.06, 0.12, 0.2, 0.32};
  constexpr int directions = 8;
  constexpr std::size_t enough = 2;  // rings, where nothing stands
  Light sum = light_at(field, sun, point, height + above, normal);
  if (field.at(point) > height + same) sum = {0, 0};
  int count = field.at(point) > height + same ? 0 : 1;
  for (std::size_t ring = 0; ring < rings.size() && (ring < enough || count < directions); ++ring)
    for (int i = 0; i < directions; ++i) {
      const double angle = 2 * std::numbers::pi * i / directions;
      const Vec2 beside = point + rings[ring] * Vec2{std::cos(angle), std::sin(angle)};
      if (std::abs(field.at(beside) - height) > same) continue;
      const Light there = light_at(field, sun, beside, height + above, normal);
      sum.sky += there.sky;
      sum.sun += there.sun;
      ++count;
    }
  if (count == 0) return light_at(field, sun, point, height + above, normal);
  const auto all = static_cast<float>(count);
  return {sum.sky / all, sum.sun / all};
}

void light_vertices(const HeightField& field, const Sun& sun, Scenery& scenery) {
  // Glass holds its opacity; the others are lit by the lightmap.
  constexpr std::array kept{Surface::Glass, Surface::Floor, Surface::Stone, Surface::Ground};
  std::vector<bool> is_kept(scenery.vertices.size());
  for (const SceneryPart& part : scenery.parts)
    if (std::ranges::find(kept, part.surface) != kept.end())
      for (std::uint32_t i = 0; i < part.index_count; ++i)
        is_kept[scenery.indices[part.first_index + i]] = true;
  for (std::size_t v = 0; v < scenery.vertices.size(); ++v) {
    SceneryVertex& vertex = scenery.vertices[v];
    // A little before the face, so that the field's texels of the solid behind it do not count.
    const Vec2 point = to_floor(vertex.position) + 1.5 * field.texel() * to_floor(vertex.normal);
    if (is_kept[v]) continue;
    const bool is_lid = vertex.normal.y > 0.9F;
    const Light light = is_lid
                            ? light_about(field, sun, point, vertex.position.y, vertex.normal)
                            : light_at(field, sun, point, vertex.position.y + 0.01, vertex.normal);
    vertex.sky = static_cast<std::uint8_t>(std::lround(255 * light.sky));
    vertex.sun = static_cast<std::uint8_t>(std::lround(255 * light.sun));
  }
}

/// Floor and Ground are lit by the lightmap.
void place_in_lightmap(Scenery& scenery) {
  const Vec2 size = scenery.lightmap_max - scenery.lightmap_min;
  for (const SceneryPart& part : scenery.parts) {
    if (part.surface == Surface::Picture) continue;
    for (std::uint32_t i = 0; i < part.index_count; ++i) {
      SceneryVertex& vertex = scenery.vertices[scenery.indices[part.first_index + i]];
      const Vec2 at = (to_floor(vertex.position) - scenery.lightmap_min) / size;
      vertex.uv = {static_cast<float>(at.x), static_cast<float>(at.y)};
    }
  }
}

Sun late_afternoon(double up) {
  constexpr double left_of_up = 1.05;
  return {.azimuth = up + left_of_up, .elevation = 0.72, .radius = 0.055};
}

}  // namespace

Scenery make_scenery(const FloorPlan& plan, std::span<const Exhibit> exhibits,
                     std::span<const float> image_aspect, std::span<const PavedArea> paving,
                     const SceneryOptions& options, std::span<ObjectStand> stands) {
  if (plan.vertex.empty()) return {};
  FloorPlan drawn = plan;  // with alcoves that nobody walks in
  std::vector<std::vector<Outline>> lift_doors;
  for (const Passage& passage : options.passages)
    if (passage.kind == ConnectionKind::Lift)
      lift_doors.push_back(add_lift_car(passage.here, drawn));
  std::vector<HoleKind> kinds = hole_kinds(drawn, exhibits);
  const std::vector<Flight> flights = flights_of(drawn, options.passages, kinds);
  const std::vector<Outline> openings = openings_of(flights);
  std::vector<bool> furniture;
  std::vector<Outline> outlines;
  for (std::size_t r = 0; r < drawn.ring.size(); ++r) {
    furniture.push_back(kinds[r] != HoleKind::Wall);
    outlines.push_back(outline_of(drawn, drawn.ring[r]));
  }

  HeightField field = make_field(drawn, options.texel);
  MeshBuilder mesh;
  build_plates(divide(drawn, furniture, wall_thickness, paving), paving, openings, mesh, field);
  build_ground(field, openings, mesh);
  std::vector<Blocker> blockers;
  for (const Flight& flight : flights) build_flight(flight, mesh, blockers);
  for (const std::vector<Outline>& leaves : lift_doors) build_lift_door(leaves, mesh);
  for (std::size_t r = 0; r < outlines.size(); ++r)
    build_hole(kinds[r], outlines[r], mesh, blockers);
  for (std::size_t e = 0; e < exhibits.size(); ++e) {
    if (exhibits[e].floor != options.floor) continue;
    ExhibitStand stand{.exhibit = static_cast<std::int32_t>(e),
                       .placement = exhibits[e].placement,
                       .aspect = image_aspect[e],
                       .on_wall = exhibits[e].place == ExhibitPlace::OnWall};
    if (!options.taken.empty()) stand.taken = options.taken[e];
    if (!stand.on_wall)
      stand.hole = hole_under(outlines, kinds, exhibits[e].placement.position, stand.on);
    if (options.objects.empty() || options.objects[e] == Vec3{0}) {
      build_stand(stand, mesh, blockers);
      continue;
    }
    const PlacedObject placed = place_object(stand, options.objects[e]);
    if (!placed.plinth.empty()) {
      build_plinth(placed.plinth, placed.plinth_height, mesh);
      blockers.push_back({placed.plinth, placed.plinth_height});
    }
    blockers.push_back(placed.shade);
    if (!stands.empty()) stands[e] = placed.stand;
  }
  for (const Blocker& blocker : blockers) {
    if (blocker.height < 0)
      field.sink(blocker.outline, blocker.height);
    else
      field.raise(blocker.outline, blocker.height);
  }

  const Sun sun = late_afternoon(options.up);
  Scenery scenery = std::move(mesh).finish();
  bake_lightmap(field, sun, scenery);
  light_vertices(field, sun, scenery);
  place_in_lightmap(scenery);
  for (SceneryVertex& vertex : scenery.vertices)
    vertex.position.y += static_cast<float>(plan.height);
  return scenery;
}

}  // namespace docent::scenery
