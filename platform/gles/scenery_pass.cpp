#include "platform/gles/scenery_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "platform/gles/shaders.h"
#include "runtime/model/floor_tint.h"
#include "runtime/scene/leaf_mesh.h"

namespace docent::gles {
namespace {

struct Paving {
  float length, width, difference, joint;  // metres; share of the tone; half-width of the joint
};
constexpr Paving oak_planks{2.4F, 0.19F, 0.13F, 0.003F};
constexpr Paving stone_slabs{1.2F, 0.8F, 0.07F, 0.004F};

/// What a gallery's floor is told by: shares of red, green and blue light, as bright together as
/// the plain floor, so that ways stand out on all of them alike. Seventh and eighth: none.
constexpr std::array<std::array<float, 3>, 8> tints{{{1.14F, 0.90F, 0.98F},  // cherry
                                                     {0.83F, 1.08F, 1.60F},  // ash
                                                     {1.02F, 1.05F, 0.62F},  // honey
                                                     {0.76F, 1.14F, 1.14F},  // sage
                                                     {0.97F, 0.97F, 1.70F},  // mauve
                                                     {0.92F, 1.06F, 0.92F},  // olive
                                                     {1, 1, 1},
                                                     {1, 1, 1}}};
static_assert(tints.size() > floor_tints);
/// Of that, what floors take on: no more than tells them apart, for the exhibits, the guide and the
/// way alone are saturated. Stone has less colour of its own.
constexpr float on_oak = 0.5F, on_stone = 0.22F;

/// Oak floors of museums are soaped: paler than the timber, so that what stands on them is seen.
constexpr float soap = 0.08F;

void draw_part(const SceneryPart& part) noexcept {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_INT,
                 buffer_offset(part.first_index * sizeof(std::uint32_t)));
}

}  // namespace

Result<void> SceneryPass::compile() {
  using namespace shaders;
  const struct {
    Program& program;
    std::string_view name, vertex, fragment;
  } all[] = {{solid_, "solid", scenery_vert, solid_frag},
             {picture_, "picture", scenery_vert, picture_frag},
             {floor_, "floor", floor_vert, floor_frag},
             {ground_, "ground", scenery_vert, ground_frag},
             {glass_, "glass", scenery_vert, glass_frag}};
  for (const auto& one : all) {
    auto program = link_program(one.name, {frame_glsl, stands_glsl, one.vertex},
                                {frame_glsl, light_glsl, one.fragment});
    if (!program) return std::unexpected(program.error());
    one.program = std::move(*program);
  }
  const struct {
    Sinking& sinking;
    std::string_view name, fragment;
  } sinking[] = {{wall_, "wall", solid_frag}, {hung_picture_, "hung picture", picture_frag}};
  for (const auto& one : sinking) {
    auto program = link_program(one.name, {frame_glsl, sinks_glsl, scenery_vert},
                                {frame_glsl, light_glsl, one.fragment});
    if (!program) return std::unexpected(program.error());
    one.sinking.program = std::move(*program);
    const Program& it = one.sinking.program;
    one.sinking.albedo = it["albedo"];
    one.sinking.glow = it["glow"];
    one.sinking.window = it["window"];
    one.sinking.cut = it["cut"];
  }
  make_levels();
  make_leaf_array();
  at_ = {solid_["albedo"], solid_["glow"],  picture_["glow"],
         floor_["albedo"], floor_["grain"], floor_["tints"]};
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

void SceneryPass::make_levels() {
  levels_ = make_texture();
  bind_texture(static_cast<GLuint>(Unit::WallLevels), levels_.get());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R8, scene::WallLevels::side, scene::WallLevels::side);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_REPEAT);
  walls_.level.resize(std::size_t{scene::WallLevels::side} * scene::WallLevels::side);
}

void SceneryPass::prepare(const scene::WallLevels& walls,
                          std::span<const scene::LeafDraw> leaves) noexcept {
  prepare_leaves(leaves);
  constexpr auto side = scene::WallLevels::side;
  bind_texture(static_cast<GLuint>(Unit::WallLevels), levels_.get());
  const bool is_whole = walls.level.size() == walls_.level.size();
  if (is_whole && walls.any && walls_.level != walls.level) {
    std::ranges::copy(walls.level, walls_.level.begin());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, side, side, GL_RED, GL_UNSIGNED_BYTE,
                    walls_.level.data());
  }
  walls_.any = walls.any && is_whole;
  walls_.column = walls.column;
  walls_.row = walls.row;
}

void SceneryPass::make_leaf_array() {
  constexpr std::size_t most = scene::most_leaves;
  leaves_.shown.reserve(most);
  leaves_.mesh.reserve(most * (scene::vertices_of_a_leaf + scene::vertices_of_its_bars));
  leaves_.array = make_vertex_array();
  glBindVertexArray(leaves_.array.get());
  leaves_.vertices = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, leaves_.vertices.get());
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(leaves_.mesh.capacity() * sizeof(SceneryVertex)), nullptr,
               GL_DYNAMIC_DRAW);
  describe_scenery_vertices();
  glBindVertexArray(0);
}

void SceneryPass::prepare_leaves(std::span<const scene::LeafDraw> leaves) noexcept {
  leaves = leaves.first(std::min(leaves.size(), scene::most_leaves));
  if (std::ranges::equal(leaves, leaves_.shown)) return;
  leaves_.shown.assign(leaves.begin(), leaves.end());
  leaves_.bars = scene::make_leaves(leaves, leaves_.mesh);
  glBindBuffer(GL_ARRAY_BUFFER, leaves_.vertices.get());
  glBufferSubData(GL_ARRAY_BUFFER, 0,
                  static_cast<GLsizeiptr>(leaves_.mesh.size() * sizeof(SceneryVertex)),
                  leaves_.mesh.data());
}

/// They do not sink: a hand may be on them.
void SceneryPass::draw_leaves() const noexcept {
  if (leaves_.mesh.empty()) return;
  glBindVertexArray(leaves_.array.get());
  solid_.use();
  const auto bars = static_cast<GLint>(leaves_.bars);
  set(at_.solid_albedo, theme_.oak);
  glDrawArrays(GL_TRIANGLES, 0, bars);
  set(at_.solid_albedo, scene::srgb(0x6B5A49));
  glDrawArrays(GL_TRIANGLES, bars, static_cast<GLint>(leaves_.mesh.size()) - bars);
}

void SceneryPass::use(const Sinking& sinking, bool hangs) const noexcept {
  constexpr auto half = static_cast<float>(scene::WallLevels::side * scene::WallLevels::cell / 2);
  constexpr auto cell = static_cast<float>(scene::WallLevels::cell);
  sinking.program.use();
  glUniform1f(sinking.glow, 0);
  glUniform3f(sinking.window, static_cast<float>(walls_.column) * cell + half,
              static_cast<float>(walls_.row) * cell + half, half);
  glUniform3f(sinking.cut, static_cast<float>(cut_height), static_cast<float>(scene::sunk_height),
              hangs ? 1.0F : 0.0F);
}

/// Walls, and the frames that hang on them. Where all of them stand they are drawn as all else is.
void SceneryPass::draw_walls(const Building& building) const noexcept {
  const std::pair<Surface, scene::Colour> plain[] = {{Surface::Plaster, theme_.plaster},
                                                     {Surface::CutFace, theme_.cut_face},
                                                     {Surface::Frame, scene::srgb(0x6B5A49)}};
  for (const auto& [surface, colour] : plain) {
    if (walls_.any)
      use(wall_, surface == Surface::Frame);
    else
      solid_.use();
    set(walls_.any ? wall_.albedo : at_.solid_albedo, colour);
    draw_surface(building, surface);
  }
}

void SceneryPass::draw_pictures(const Building& building, std::optional<std::uint32_t> highlighted,
                                const Textures& textures) const noexcept {
  for (const SceneryPart& part : building.scenery.parts) {
    if (part.surface != Surface::Picture) continue;
    const auto exhibit = static_cast<std::uint32_t>(part.exhibit);
    const bool is_known = exhibit < building.image_of.size();
    const auto* image = is_known ? textures.find(building.image_of[exhibit]) : nullptr;
    const bool sinks = walls_.any && is_known && building.hangs[exhibit];
    if (sinks)
      use(hung_picture_, true);
    else
      picture_.use();
    bind_texture(static_cast<GLuint>(Unit::Image), image ? image->texture.get() : 0);
    glUniform1f(sinks ? hung_picture_.glow : at_.picture_glow,
                exhibit == highlighted ? 0.30F : 0.0F);
    draw_part(part);
  }
}

void SceneryPass::draw_solids(const Building& building, std::optional<std::uint32_t> highlighted,
                              const Textures& textures) const noexcept {
  glBindVertexArray(building.array.get());
  solid_.use();
  glUniform1f(at_.solid_glow, 0);
  draw_walls(building);
  solid_.use();
  const std::pair<Surface, scene::Colour> plain[] = {{Surface::CaseBody, scene::srgb(0xDCD3C3)},
                                                     {Surface::Object, scene::srgb(0xEFE9DD)}};
  for (const auto& [surface, colour] : plain) {
    set(at_.solid_albedo, colour);
    draw_surface(building, surface);
  }
  draw_pictures(building, highlighted, textures);
  draw_leaves();
}

void SceneryPass::draw_floors(const Building& building) const noexcept {
  glBindVertexArray(building.array.get());
  floor_.use();
  const auto pave = [&](Surface surface, const scene::Colour& colour, const Paving& paving,
                        float share) {
    std::array<float, 4 * tints.size()> shown{};
    for (std::size_t i = 0; i < tints.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) shown[4 * i + c] = 1 + share * (tints[i][c] - 1);
    glUniform4fv(at_.floor_tints, static_cast<GLsizei>(tints.size()), shown.data());
    set(at_.floor_albedo, colour);
    glUniform4f(at_.floor_grain, paving.length, paving.width, paving.difference, paving.joint);
    draw_surface(building, surface);
  };
  pave(Surface::Floor, mixed(theme_.oak, theme_.plaster, soap), oak_planks, on_oak);
  pave(Surface::Stone, theme_.stone, stone_slabs, on_stone);
  ground_.use();
  draw_surface(building, Surface::Ground);
}

void SceneryPass::draw_glass(const Building& building) const noexcept {
  glBindVertexArray(building.array.get());
  glass_.use();
  draw_surface(building, Surface::Glass);
}

}  // namespace docent::gles
