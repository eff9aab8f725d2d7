#include "platform/gles/scenery_pass.h"

#include <cstddef>
#include <utility>

#include "platform/gles/shaders.h"

namespace docent::gles {
namespace {

struct Paving {
  float length, width, difference, joint;  // metres; share of the tone; half-width of the joint
};
constexpr Paving oak_planks{2.4F, 0.19F, 0.13F, 0.003F};
constexpr Paving stone_slabs{1.2F, 0.8F, 0.07F, 0.004F};

/// Oak floors of museums are soaped: paler than the timber, so that what stands on them is seen.
constexpr float soap = 0.08F;

scene::Colour mixed(const scene::Colour& a, const scene::Colour& b, float share) noexcept {
  return {a.r + (b.r - a.r) * share, a.g + (b.g - a.g) * share, a.b + (b.b - a.b) * share, 1};
}

void describe_scenery_vertices() noexcept {
  constexpr auto stride = static_cast<GLsizei>(sizeof(SceneryVertex));
  const auto floats = [&](GLuint index, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, stride, buffer_offset(offset));
  };
  floats(0, 3, offsetof(SceneryVertex, position));
  floats(1, 3, offsetof(SceneryVertex, normal));
  floats(2, 2, offsetof(SceneryVertex, uv));
  static_assert(offsetof(SceneryVertex, sun) == offsetof(SceneryVertex, sky) + 1);
  glEnableVertexAttribArray(3);
  glVertexAttribPointer(3, 2, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        buffer_offset(offsetof(SceneryVertex, sky)));
}

GlTexture upload_lightmap(const Scenery& scenery) noexcept {
  GlTexture texture = make_texture();
  bind_texture(static_cast<GLuint>(Unit::LightMap), texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGB8, static_cast<GLsizei>(scenery.lightmap_width),
                 static_cast<GLsizei>(scenery.lightmap_height));
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(scenery.lightmap_width),
                  static_cast<GLsizei>(scenery.lightmap_height), GL_RGB, GL_UNSIGNED_BYTE,
                  scenery.lightmap.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  return texture;
}

float height_of_floor(const Scenery& scenery) noexcept {
  for (const SceneryPart& part : scenery.parts)
    if (part.surface == Surface::Floor || part.surface == Surface::Stone)
      return scenery.vertices[scenery.indices[part.first_index]].position.y;
  return 0;
}

void draw_part(const SceneryPart& part) noexcept {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_INT,
                 buffer_offset(part.first_index * sizeof(std::uint32_t)));
}

}  // namespace

Result<void> SceneryPass::compile() {
  using namespace shaders;
  const struct {
    Program& program;
    std::string_view name, fragment;
  } all[] = {{solid_, "solid", solid_frag},
             {picture_, "picture", picture_frag},
             {floor_, "floor", floor_frag},
             {ground_, "ground", ground_frag},
             {glass_, "glass", glass_frag}};
  for (const auto& one : all) {
    auto program =
        link_program(one.name, {frame_glsl, scenery_vert}, {frame_glsl, light_glsl, one.fragment});
    if (!program) return std::unexpected(program.error());
    one.program = std::move(*program);
  }
  at_ = {solid_["albedo"], solid_["glow"], picture_["glow"], floor_["albedo"], floor_["grain"]};
  return {};
}

void SceneryPass::upload(std::uint32_t floor, const Scenery& scenery,
                         std::span<const scene::TextureId> image_of) {
  if (buildings_.size() <= floor) buildings_.resize(floor + 1);
  Building building;
  building.image_of.assign(image_of.begin(), image_of.end());
  building.scenery.parts = scenery.parts;
  building.scenery.lightmap_min = scenery.lightmap_min;
  building.scenery.lightmap_max = scenery.lightmap_max;
  building.scenery.sun = scenery.sun;
  building.floor_height = height_of_floor(scenery);
  if (!scenery.vertices.empty()) {
    building.array = make_vertex_array();
    glBindVertexArray(building.array.get());
    building.vertices = make_buffer();
    glBindBuffer(GL_ARRAY_BUFFER, building.vertices.get());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(scenery.vertices.size() * sizeof(SceneryVertex)),
                 scenery.vertices.data(), GL_STATIC_DRAW);
    building.indices = make_buffer();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, building.indices.get());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(scenery.indices.size() * sizeof(std::uint32_t)),
                 scenery.indices.data(), GL_STATIC_DRAW);
    describe_scenery_vertices();
    building.lightmap = upload_lightmap(scenery);
    glBindVertexArray(0);
  }
  buildings_[floor] = std::move(building);
}

const SceneryPass::Building* SceneryPass::building(std::uint32_t floor) const noexcept {
  if (floor >= buildings_.size() || !buildings_[floor].array) return nullptr;
  return &buildings_[floor];
}

const Scenery* SceneryPass::scenery_of(std::uint32_t floor) const noexcept {
  const Building* found = building(floor);
  return found ? &found->scenery : nullptr;
}

float SceneryPass::floor_height(std::uint32_t floor) const noexcept {
  const Building* found = building(floor);
  return found ? found->floor_height : 0;
}

void SceneryPass::bind_light(std::uint32_t floor) const noexcept {
  const Building* found = building(floor);
  bind_texture(static_cast<GLuint>(Unit::LightMap), found ? found->lightmap.get() : 0);
}

void SceneryPass::draw_surface(const Building& building, Surface surface) const noexcept {
  SceneryPart run{surface, -1, 0, 0};  // parts of a surface lie next to each other: one call
  for (const SceneryPart& part : building.scenery.parts) {
    if (part.surface != surface) continue;
    if (run.index_count > 0 && run.first_index + run.index_count != part.first_index) {
      draw_part(run);
      run.index_count = 0;
    }
    if (run.index_count == 0) run.first_index = part.first_index;
    run.index_count += part.index_count;
  }
  if (run.index_count > 0) draw_part(run);
}

void SceneryPass::draw_solids(std::uint32_t floor, std::optional<std::uint32_t> highlighted,
                              const Textures& textures) const noexcept {
  const Building* found = building(floor);
  if (!found) return;
  glBindVertexArray(found->array.get());
  solid_.use();
  glUniform1f(at_.solid_glow, 0);
  const std::pair<Surface, scene::Colour> plain[] = {{Surface::Plaster, theme_.plaster},
                                                     {Surface::CutFace, theme_.cut_face},
                                                     {Surface::CaseBody, scene::srgb(0xDCD3C3)},
                                                     {Surface::Frame, scene::srgb(0x6B5A49)},
                                                     {Surface::Object, scene::srgb(0xEFE9DD)}};
  for (const auto& [surface, colour] : plain) {
    set(at_.solid_albedo, colour);
    draw_surface(*found, surface);
  }
  picture_.use();
  for (const SceneryPart& part : found->scenery.parts) {
    if (part.surface != Surface::Picture) continue;
    const auto exhibit = static_cast<std::uint32_t>(part.exhibit);
    const auto* image =
        exhibit < found->image_of.size() ? textures.find(found->image_of[exhibit]) : nullptr;
    bind_texture(static_cast<GLuint>(Unit::Image), image ? image->texture.get() : 0);
    glUniform1f(at_.picture_glow, exhibit == highlighted ? 0.30F : 0.0F);
    draw_part(part);
  }
}

void SceneryPass::draw_floors(std::uint32_t floor) const noexcept {
  const Building* found = building(floor);
  if (!found) return;
  glBindVertexArray(found->array.get());
  floor_.use();
  const auto pave = [&](Surface surface, const scene::Colour& colour, const Paving& paving) {
    set(at_.floor_albedo, colour);
    glUniform4f(at_.floor_grain, paving.length, paving.width, paving.difference, paving.joint);
    draw_surface(*found, surface);
  };
  pave(Surface::Floor, mixed(theme_.oak, theme_.plaster, soap), oak_planks);
  pave(Surface::Stone, theme_.stone, stone_slabs);
  ground_.use();
  draw_surface(*found, Surface::Ground);
}

void SceneryPass::draw_glass(std::uint32_t floor) const noexcept {
  const Building* found = building(floor);
  if (!found) return;
  glBindVertexArray(found->array.get());
  glass_.use();
  draw_surface(*found, Surface::Glass);
}

}  // namespace docent::gles
