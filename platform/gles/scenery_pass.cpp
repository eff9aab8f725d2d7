#include "platform/gles/scenery_pass.h"

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

void SceneryPass::draw_solids(const Building& building, std::optional<std::uint32_t> highlighted,
                              const Textures& textures) const noexcept {
  glBindVertexArray(building.array.get());
  solid_.use();
  glUniform1f(at_.solid_glow, 0);
  const std::pair<Surface, scene::Colour> plain[] = {{Surface::Plaster, theme_.plaster},
                                                     {Surface::CutFace, theme_.cut_face},
                                                     {Surface::CaseBody, scene::srgb(0xDCD3C3)},
                                                     {Surface::Frame, scene::srgb(0x6B5A49)},
                                                     {Surface::Object, scene::srgb(0xEFE9DD)}};
  for (const auto& [surface, colour] : plain) {
    set(at_.solid_albedo, colour);
    draw_surface(building, surface);
  }
  picture_.use();
  for (const SceneryPart& part : building.scenery.parts) {
    if (part.surface != Surface::Picture) continue;
    const auto exhibit = static_cast<std::uint32_t>(part.exhibit);
    const auto* image =
        exhibit < building.image_of.size() ? textures.find(building.image_of[exhibit]) : nullptr;
    bind_texture(static_cast<GLuint>(Unit::Image), image ? image->texture.get() : 0);
    glUniform1f(at_.picture_glow, exhibit == highlighted ? 0.30F : 0.0F);
    draw_part(part);
  }
}

void SceneryPass::draw_floors(const Building& building) const noexcept {
  glBindVertexArray(building.array.get());
  floor_.use();
  const auto pave = [&](Surface surface, const scene::Colour& colour, const Paving& paving) {
    set(at_.floor_albedo, colour);
    glUniform4f(at_.floor_grain, paving.length, paving.width, paving.difference, paving.joint);
    draw_surface(building, surface);
  };
  pave(Surface::Floor, mixed(theme_.oak, theme_.plaster, soap), oak_planks);
  pave(Surface::Stone, theme_.stone, stone_slabs);
  ground_.use();
  draw_surface(building, Surface::Ground);
}

void SceneryPass::draw_glass(const Building& building) const noexcept {
  glBindVertexArray(building.array.get());
  glass_.use();
  draw_surface(building, Surface::Glass);
}

}  // namespace docent::gles
