#include "content/scenery/scenery.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "content/scenery/baked_light.h"
#include "content/scenery/furniture.h"
#include "content/scenery/mesh_builder.h"
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

void build_plates(const Plates& plates, std::span<const PavedArea> paving, MeshBuilder& mesh,
                  HeightField& field) {
  constexpr Vec3 up{0, 1, 0};
  for (const Plate& plate : plates.plates) {
    const double height = plate.region == PlateKind::Wall ? cut_height : 0;
    mesh.use(surface_of(plate, paving));
    mesh.triangle({to_world(plate.corner[0], height), to_world(plate.corner[1], height),
                   to_world(plate.corner[2], height)},
                  up);
    if (plate.region == PlateKind::Wall) field.raise(plate.corner, height);
  }
  constexpr std::array rows{0.0, 0.1, 0.3, 0.7, cut_height};
  mesh.use(Surface::Plaster);
  for (const WallEdge& edge : plates.wall_edges) mesh.wall(edge.a, edge.b, rows);
}

/// The table on which the model stands.
void build_ground(const HeightField& field, MeshBuilder& mesh) {
  constexpr double below = -0.01;
  const Vec2 low = field.low();
  const Vec2 high = field.high();
  mesh.use(Surface::Ground);
  mesh.quad({to_world(low, below), to_world({high.x, low.y}, below), to_world(high, below),
             to_world({low.x, high.y}, below)});
}

/// The hole that an exhibit stands in, or null.
const Outline* hole_under(const std::vector<Outline>& holes, const std::vector<HoleKind>& kinds,
                          Vec2 p, HoleKind& kind) {
  for (std::size_t r = 0; r < holes.size(); ++r) {
    if (kinds[r] == HoleKind::Wall || !contains(holes[r], p)) continue;
    kind = kinds[r];
    return &holes[r];
  }
  return nullptr;
}

void light_vertices(const HeightField& field, const Sun& sun, Scenery& scenery) {
  std::vector<bool> is_glass(scenery.vertices.size());
  for (const SceneryPart& part : scenery.parts)
    if (part.surface == Surface::Glass)
      for (std::uint32_t i = 0; i < part.index_count; ++i)
        is_glass[scenery.indices[part.first_index + i]] = true;
  for (std::size_t v = 0; v < scenery.vertices.size(); ++v) {
    SceneryVertex& vertex = scenery.vertices[v];
    // A little before the face, so that the field's texels of the solid behind it do not count.
    const Vec2 point = to_floor(vertex.position) + 1.5 * field.texel() * to_floor(vertex.normal);
    const bool is_level = vertex.normal.y > 0.999F && vertex.position.y <= 0;
    if (is_level || is_glass[v]) continue;  // lit by the lightmap; holds its opacity
    const Light light = light_at(field, sun, point, vertex.position.y + 0.01, vertex.normal);
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
                     const SceneryOptions& options) {
  if (plan.vertex.empty()) return {};
  const std::vector<HoleKind> kinds = hole_kinds(plan, exhibits);
  std::vector<bool> furniture;
  std::vector<Outline> outlines;
  for (std::size_t r = 0; r < plan.ring.size(); ++r) {
    furniture.push_back(kinds[r] != HoleKind::Wall);
    outlines.push_back(outline_of(plan, plan.ring[r]));
  }

  HeightField field = make_field(plan, options.texel);
  MeshBuilder mesh;
  build_plates(divide(plan, furniture, wall_thickness, paving), paving, mesh, field);
  build_ground(field, mesh);
  std::vector<Blocker> blockers;
  for (std::size_t r = 0; r < outlines.size(); ++r)
    build_hole(kinds[r], outlines[r], mesh, blockers);
  for (std::size_t e = 0; e < exhibits.size(); ++e) {
    if (exhibits[e].floor != options.floor) continue;
    ExhibitStand stand{.exhibit = static_cast<std::int32_t>(e),
                       .placement = exhibits[e].placement,
                       .aspect = image_aspect[e],
                       .on_wall = exhibits[e].place == ExhibitPlace::OnWall};
    if (!stand.on_wall)
      stand.hole = hole_under(outlines, kinds, exhibits[e].placement.position, stand.on);
    build_stand(stand, mesh, blockers);
  }
  for (const Blocker& blocker : blockers) field.raise(blocker.outline, blocker.height);

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
