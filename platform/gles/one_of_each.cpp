#include "platform/gles/one_of_each.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "platform/image/image.h"

namespace docent::gles {
namespace {

/// Of textures. Where sides are powers of two llvmpipe has code of its own.
constexpr std::uint32_t side = 3;
constexpr scene::TextureId image{1}, scenery_image{2}, text{3};

/// Counter-clockwise in clip space, which is the list's world.
constexpr std::array<Vec3, 3> corners{Vec3{0, 0, 0}, Vec3{0.05F, 0, 0}, Vec3{0, 0.05F, 0}};

void append_part(Surface surface, std::int32_t exhibit, Scenery& scenery) {
  const auto first = static_cast<std::uint32_t>(scenery.vertices.size());
  scenery.parts.push_back({surface, exhibit, first, 3});
  for (const Vec3 corner : corners) {
    scenery.indices.push_back(static_cast<std::uint32_t>(scenery.vertices.size()));
    scenery.vertices.push_back({.position = corner, .normal = {0, 1, 0}});
  }
}

/// A picture that hangs on a wall and sinks with it, and one that stands by itself.
Scenery building() {
  Scenery scenery;
  for (std::size_t s = 0; s < static_cast<std::size_t>(Surface::Count); ++s)
    append_part(static_cast<Surface>(s), 0, scenery);
  append_part(Surface::Picture, 1, scenery);
  scenery.lightmap_width = scenery.lightmap_height = side;
  scenery.lightmap_max = {1, 1};
  scenery.lightmap.resize(std::size_t{side} * side * Scenery::lightmap_channels);
  scenery.sun = {0, 1, 0};
  return scenery;
}

/// All levels are its one triangle.
void add_body(Holdings& holdings) {
  SkinnedMesh mesh;
  for (const Vec3 corner : corners)
    mesh.vertices.push_back(
        {.position = corner, .normal = {0, 1, 0}, .joint = {}, .weight = {255, 0, 0, 0}});
  mesh.indices = {0, 1, 2};
  mesh.figure_end = {3};
  mesh.inverse_bind = {Mat4(1)};
  scene::BodyLevels levels;
  levels.indices = mesh.indices;
  levels.figure.emplace_back().fill({.first = 0, .size = 3});
  holdings.set_body(mesh, levels);
}

void add_object(Holdings& holdings) {
  ObjectMesh mesh;
  mesh.vertices = {
      {.position = {0, 0, 0}}, {.position = {65535, 0, 0}}, {.position = {0, 65535, 0}}};
  mesh.triangles = {0, 1, 2};
  holdings.add_object(0, Vec3{0.05F}, mesh);
}

Holdings holdings_of_each() {
  Holdings holdings;
  const Pixels dots{side, side,
                    std::vector<std::byte>(std::size_t{4} * side * side, std::byte{255})};
  holdings.add_image(image, dots);
  holdings.add_scenery_image(scenery_image, image::mip_levels(dots));
  holdings.add_text(text, side, side,
                    std::vector<std::uint8_t>(std::size_t{side} * side, std::uint8_t{255}));
  const Scenery scenery = building();
  while (holdings.add_scenery(0, scenery, std::array{scenery_image, scenery_image})) {
  }
  add_body(holdings);
  add_object(holdings);
  return holdings;
}

scene::DrawList list_of_each() {
  scene::DrawList list;
  list.camera.eye = {0, 10, 0};
  list.walls.any = true;
  list.walls.level.resize(std::size_t{scene::WallLevels::side} * scene::WallLevels::side);
  list.leaves.emplace_back();
  list.ribbon_point = {{0, 0}, {1, 0}};
  list.ribbons.push_back({.count = 2, .length = 1});
  list.markers.emplace_back();
  list.objects.emplace_back();
  list.palette = {Mat4(1)};
  list.avatars.emplace_back();
  for (const scene::QuadFill fill :
       {scene::QuadFill::Solid, scene::QuadFill::Text, scene::QuadFill::Image})
    list.quads.push_back({.rect = {0, 0, 0.1F, 0.1F},
                          .fill = fill,
                          .colour = {},
                          .texture = fill == scene::QuadFill::Text ? text : image});
  return list;
}

}  // namespace

OneOfEach one_of_each() {
  return {.holdings = holdings_of_each(), .list = list_of_each()};
}

}  // namespace docent::gles
