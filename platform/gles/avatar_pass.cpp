#include "platform/gles/avatar_pass.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "platform/gles/shaders.h"
#include "runtime/model/motion/skeleton.h"
#include "runtime/scene/look.h"
#include "runtime/scene/uncovered.h"

namespace docent::gles {
namespace {

constexpr float body_height = 1.85F;
constexpr float most_height = 2.15F;  // a museum's own character may be taller than our guides
constexpr float body_reach = 0.55F;   // metres from the hips to a hand or foot, along x or z

// A uniform block may have 16 KB in every OpenGL ES 3.0, and a range of a buffer
// begin at a multiple of 256 bytes at worst. Both are those of avatar_record.glsl.
constexpr std::size_t block_size = 1024;  // vec4s
constexpr std::size_t block_bytes = block_size * sizeof(Vec4);
constexpr std::size_t alignment = 256 / sizeof(Vec4);
constexpr std::size_t first_matrix_row = 5;

// The atlas has room for sixteen shadows; beyond that the furthest share a tile by four.
constexpr GLsizei atlas_side = 512;  // texels
constexpr std::size_t tiles_a_row = 4;
constexpr std::size_t tile_count = tiles_a_row * tiles_a_row;
constexpr GLsizei atlas_levels = 5;  // the softest shadow is blurred over 16 texels
static_assert(AvatarPass::most_avatars <= 4 * tile_count);

/// In a crowd everybody but the first avatar is drawn as if smaller, down to the last of these
/// shares, until the bodies together have no more triangles than this.
constexpr std::array crowd_shares{1.0F, 0.8F, 0.65F, 0.55F, 0.45F};
constexpr std::size_t most_triangles = 80'000;

// Parts of a look in look.glsl.
constexpr std::size_t build_part = 11, parts_of_look = 12;
/// The look of a museum's own character, after ours: it has its own colours and height.
constexpr std::size_t own_look = scene::looks.size();
static_assert((own_look + 1) * parts_of_look == 156);
static_assert(static_cast<std::size_t>(Material::Count) == build_part);

Vec4 matte(std::uint32_t hex, float shine = 0) noexcept {
  const scene::Colour c = scene::srgb(hex);
  return {c.r, c.g, c.b, shine};
}

std::array<Vec4, parts_of_look> parts_of(const scene::Look& look) noexcept {
  std::array<Vec4, parts_of_look> parts{};
  const auto at = [&](Material material) -> Vec4& {
    return parts[static_cast<std::size_t>(material)];
  };
  at(Material::Skin) = matte(look.skin, 0.02F);
  at(Material::Hair) = matte(look.hair, 0.05F);
  at(Material::Coat) = matte(look.coat, 0.01F);
  at(Material::Trousers) = matte(look.trousers);
  at(Material::Shoes) = matte(look.shoes, 0.06F);
  at(Material::Shirt) = matte(look.shirt);
  at(Material::Eye) = matte(0x241E1B, 0.6F);
  at(Material::White) = matte(0xDDD5C8, 0.1F);
  at(Material::Lips) = at(Material::Skin) * Vec4(0.74F, 0.58F, 0.57F, 3);
  at(Material::Second) = matte(look.second, 0.01F);
  at(Material::Own) = matte(0xFFFFFF, 0.02F);
  parts[build_part] = {look.height, 0, 0, 0};
  return parts;
}

std::size_t matrices_of(const Body& body) noexcept {
  return std::min(body.matrices, most_joints);
}

/// Which of the bodies it wears.
std::uint32_t figure_of(const scene::AvatarDraw& avatar, const Body& body) noexcept {
  return scene::body_of(avatar.look, body.figure.size(), body.has_own);
}
bool is_own(std::uint32_t figure, const Body& body) noexcept {
  return body.has_own && figure + 1 == body.figure.size();
}

/// Middle and half size, in clip space, of the tile of the atlas that the avatar in this place has.
Vec4 tile_of(std::size_t place, std::size_t count) noexcept {
  const std::size_t whole =
      count <= tile_count ? count : (4 * tile_count - count) / 3;  // the others fit four by four
  const std::size_t quarter = place < whole ? 0 : (place - whole) % 4;
  const std::size_t tile = place < whole ? place : whole + (place - whole) / 4;
  constexpr float half = 1.0F / tiles_a_row;
  const auto middle = [&](std::size_t i, std::size_t part) {
    const float of_tile = half * (2 * static_cast<float>(i) + 1) - 1;
    return place < whole ? of_tile : of_tile + half * (static_cast<float>(part) - 0.5F);
  };
  const std::size_t row = tile / tiles_a_row;
  const float size = place < whole ? half : half / 2;
  return {middle(tile % tiles_a_row, quarter % 2), middle(row, quarter / 2), size, size};
}

/// The square of floor from the feet to the tip of the shadow.
Vec4 shadow_window(Vec3 hips, float scale, Vec3 sun) noexcept {
  const Vec3 throw_of_head = sun * (-scale * body_height / std::max(sun.y, 0.2F));
  const Vec3 middle = hips + 0.5F * throw_of_head;
  const float half =
      0.5F * std::max(std::abs(throw_of_head.x), std::abs(throw_of_head.z)) + 0.75F * scale;
  return {middle.x, middle.z, half, 0};
}

/// Not beside the picture and not behind a part of the interface that lets nothing through.
bool is_in_picture(const Extent& extent, std::span<const scene::Quad> interface) noexcept {
  if (extent.outside != 0) return false;
  if (extent.reaches_behind_eye) return true;
  const float x = 0.5F + 0.5F * extent.left, end_x = 0.5F + 0.5F * extent.right;
  const float y = 0.5F - 0.5F * extent.high, end_y = 0.5F - 0.5F * extent.low;
  return std::ranges::none_of(interface, [&](const scene::Quad& quad) {
    const scene::Rect& r = quad.rect;
    return scene::is_opaque(quad) && quad.corner <= 0 && (r.x <= 0 || r.x <= x) &&
           (r.y <= 0 || r.y <= y) && (r.x + r.width >= 1 || r.x + r.width >= end_x) &&
           (r.y + r.height >= 1 || r.y + r.height >= end_y);
  });
}

SceneBuffer::Rows rows_of(const Extent& extent) noexcept {
  return extent.reaches_behind_eye ? SceneBuffer::Rows{-1, 1}
                                   : SceneBuffer::Rows{extent.low, extent.high};
}

/// `beyond`: metres that it reaches further than people do.
Extent extent_of_body(const Mat4& to_clip, const scene::AvatarDraw& avatar, float beyond) noexcept {
  const Vec3 hips = avatar.centre;
  const float scale = avatar.scale, floor = avatar.feet[0].y, reach = body_reach + beyond;
  Extent extent;
  for (const float x : {-reach, reach})
    for (const float z : {-reach, reach})
      for (const float height : {-beyond, most_height + beyond})
        extent.include(to_clip, {hips.x + scale * x, floor + scale * height, hips.z + scale * z});
  return extent;
}

Extent extent_of_shadow(const Mat4& to_clip, const Vec4& window, float floor) noexcept {
  Extent extent;
  for (const float x : {-window.z, window.z})
    for (const float z : {-window.z, window.z})
      extent.include(to_clip, {window.x + x, floor, window.y + z});
  return extent;
}

/// Metres beyond a joint at which something of a body may be, as it is built and turned by looks:
/// hats, hands, hair.
constexpr float reach_of_joint = 0.4F;
constexpr float built_wider = 0.1F;

/// Of a museum's own character: wings, a staff, a train.
float beyond_people(const scene::AvatarDraw& avatar, const Body& body) noexcept {
  const std::uint32_t figure = figure_of(avatar, body);
  if (figure >= body.reach.size()) return 0;
  return std::max(0.0F, body.reach[figure] + built_wider - reach_of_joint);
}

/// About a body in any pose, and its shadow.
Region region_of(const scene::DrawList& list, std::size_t avatar, const Body& body, Vec3 sun,
                 PixelSize picture) noexcept {
  const scene::AvatarDraw& one = list.avatars[avatar];
  const Mat4 to_clip = list.camera.projection * list.camera.view;
  Extent extent =
      extent_of_shadow(to_clip, shadow_window(one.centre, one.scale, sun), one.feet[0].y);
  const Mat4 from_eye = glm::transpose(list.camera.view);  // its rows are the picture's axes
  const float reach = one.scale * (reach_of_joint + beyond_people(one, body));
  const Vec3 across = reach * Vec3(from_eye[0]), up = reach * Vec3(from_eye[1]);
  const std::size_t end =
      avatar + 1 < list.avatars.size() ? list.avatars[avatar + 1].first_matrix : list.joint.size();
  for (std::size_t j = one.first_matrix; j < std::min(end, list.joint.size()); ++j)
    for (const Vec3 beside : {-across - up, across - up, up - across, across + up})
      extent.include(to_clip, list.joint[j] + beside);
  return region_of(extent, picture);
}

}  // namespace

Region AvatarPass::moved(const scene::DrawList& list, const scene::Change& change, const Body& body,
                         Vec3 sun, PixelSize picture) noexcept {
  Region all;
  for (std::size_t a = 0; a < std::min(list.avatars.size(), most_avatars); ++a) {
    if (!change.everything && !change.model && !change.bodies.test(a)) continue;
    all.include(regions_[a]);
    regions_[a] = region_of(list, a, body, sun, picture);
    all.include(regions_[a]);
  }
  return all;
}

Result<void> AvatarPass::compile() {
  using namespace shaders;
  auto body =
      link_program("avatar", {frame_glsl, avatar_record_glsl, look_glsl, skin_glsl, avatar_vert},
                   {frame_glsl, light_glsl, avatar_frag});
  if (!body) return std::unexpected(body.error());
  auto shadow = link_program(
      "shadow", {frame_glsl, avatar_record_glsl, look_glsl, skin_glsl, shadow_vert}, {shadow_frag});
  if (!shadow) return std::unexpected(shadow.error());
  auto soften = link_program("soften", {frame_glsl, avatar_record_glsl, soften_vert},
                             {frame_glsl, soften_frag});
  if (!soften) return std::unexpected(soften.error());
  auto decal = link_program("decal", {frame_glsl, avatar_record_glsl, decal_vert},
                            {frame_glsl, light_glsl, decal_frag});
  if (!decal) return std::unexpected(decal.error());
  body_ = std::move(*body);
  shadow_ = std::move(*shadow);
  soften_ = std::move(*soften);
  decal_ = std::move(*decal);
  at_ = {body_["record_size"], shadow_["record_size"], soften_["record_size"],
         decal_["record_size"]};

  no_attributes_ = make_vertex_array();
  std::vector<Vec4> parts;
  for (const scene::Look& look : scene::looks) {
    const auto of_look = parts_of(look);
    parts.insert(parts.end(), of_look.begin(), of_look.end());
  }
  const auto own = parts_of({.name = {}});
  parts.insert(parts.end(), own.begin(), own.end());
  looks_ = make_buffer();
  glBindBuffer(GL_UNIFORM_BUFFER, looks_.get());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(parts.size() * sizeof(Vec4)),
               parts.data(), GL_STATIC_DRAW);
  records_ = make_buffer();
  atlas_ = make_texture();
  bind_texture(static_cast<GLuint>(Unit::ShadowAtlas), atlas_.get());
  glTexStorage2D(GL_TEXTURE_2D, atlas_levels, GL_R8, atlas_side, atlas_side);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  atlas_framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, atlas_framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, atlas_.get(), 0);
  soft_atlas_ = make_texture();
  bind_texture(static_cast<GLuint>(Unit::ShadowAtlas), soft_atlas_.get());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_R8, atlas_side, atlas_side);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  soft_framebuffer_ = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, soft_framebuffer_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, soft_atlas_.get(), 0);
  return {};
}

void AvatarPass::choose(const scene::DrawList& list, Vec3 sun, PixelSize picture) noexcept {
  seen_count_ = 0;
  const Mat4 to_clip = list.camera.projection * list.camera.view;
  const float scale = 0.5F * static_cast<float>(picture.height) * body_height *
                      std::abs(list.camera.projection[1][1]);
  for (std::size_t a = 0; a < std::min(list.avatars.size(), most_avatars); ++a) {
    const Vec3 hips = list.avatars[a].centre;
    const float larger = list.avatars[a].scale;
    const Vec4 window = shadow_window(hips, larger, sun);
    const float floor = list.avatars[a].feet[0].y;
    const Extent body =
        extent_of_body(to_clip, list.avatars[a], beyond_people(list.avatars[a], *worn_));
    const Extent shadow = extent_of_shadow(to_clip, window, floor);
    const bool sees_body = is_in_picture(body, list.quads);
    const bool sees_shadow = is_in_picture(shadow, list.quads);
    if (!sees_body && !sees_shadow) continue;
    constexpr SceneBuffer::Rows nowhere{2, -2};
    seen_[seen_count_++] = {
        .avatar = static_cast<std::uint32_t>(a),
        .figure = figure_of(list.avatars[a], *worn_),
        .pixels = sees_body ? larger * scale / std::max((to_clip * Vec4(hips, 1)).w, 0.01F) : 0,
        .window = window,
        .body = sees_body ? rows_of(body) : nowhere,
        .shadow = sees_shadow ? rows_of(shadow) : nowhere};
  }
  choose_levels();
  std::sort(seen_.begin(), seen_.begin() + static_cast<std::ptrdiff_t>(seen_count_),
            [](const Seen& a, const Seen& b) {
              return std::tie(a.level, a.figure, a.body.low, a.avatar) <
                     std::tie(b.level, b.figure, b.body.low, b.avatar);
            });
}

void AvatarPass::choose_levels() noexcept {
  for (const float share : crowd_shares) {
    std::size_t triangles = 0;
    for (Seen& seen : std::span(seen_).first(seen_count_)) {
      const float pixels = seen.avatar == 0 ? seen.pixels : share * seen.pixels;
      seen.level = static_cast<std::uint32_t>(std::ranges::count_if(
          scene::coarse_levels,
          [&](const scene::Coarseness& coarse) { return pixels < coarse.height; }));
      triangles += static_cast<std::size_t>(worn_->figure[seen.figure][seen.level].size) / 3;
    }
    if (triangles <= most_triangles) return;
  }
}

void AvatarPass::reserve(std::size_t avatars) noexcept {
  const std::size_t needed = avatars * record_size_;
  if (needed <= capacity_) return;
  capacity_ = std::max(needed, std::min(2 * capacity_, most_avatars * record_size_));
  // Whoever comes last is bound with a whole block, too.
  glBindBuffer(GL_UNIFORM_BUFFER, records_.get());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(capacity_ * sizeof(Vec4) + block_bytes),
               nullptr, GL_STREAM_DRAW);
}

void AvatarPass::write_record(const scene::DrawList& list, std::size_t place,
                              Vec4* record) const noexcept {
  const Seen& seen = seen_[place];
  const scene::AvatarDraw& avatar = list.avatars[seen.avatar];
  record[0] = Vec4(avatar.feet[0], avatar.foot_height[0]);
  record[1] = Vec4(avatar.feet[1], avatar.foot_height[1]);
  const std::size_t look =
      is_own(seen.figure, *worn_) ? own_look : avatar.look % scene::looks.size();
  record[2] = Vec4(avatar.centre, static_cast<float>(look));
  record[3] = seen.window;
  record[4] = tile_of(place, seen_count_);
  const std::size_t first = std::min<std::size_t>(avatar.first_matrix, list.palette.size());
  const std::size_t matrices = std::min(matrices_of(*worn_), list.palette.size() - first);
  Vec4* row = record + first_matrix_row;
  for (std::size_t j = 0; j < matrices; ++j) {
    const Mat4 rows = glm::transpose(list.palette[first + j]);
    for (int r = 0; r < 3; ++r) *row++ = rows[r];
  }
  std::fill(row, record + record_size_, Vec4(0));
}

void AvatarPass::send(const scene::DrawList& list) noexcept {
  reserve(seen_count_);
  glBindBuffer(GL_UNIFORM_BUFFER, records_.get());
  void* mapped = glMapBufferRange(
      GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(seen_count_ * record_size_ * sizeof(Vec4)),
      GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (mapped == nullptr) {
    seen_count_ = 0;
    return;
  }
  auto* record = static_cast<Vec4*>(mapped);
  for (std::size_t place = 0; place < seen_count_; ++place, record += record_size_)
    write_record(list, place, record);
  if (glUnmapBuffer(GL_UNIFORM_BUFFER) == GL_FALSE) seen_count_ = 0;  // lost, as ES allows
}

/// Calls `draw` for runs of avatars of one body and level whose `part` reaches into the rows, each
/// run bound.
template <typename Draw>
void AvatarPass::draw_batches(SceneBuffer::Rows rows, SceneBuffer::Rows Seen::* part,
                              Draw draw) const noexcept {
  const std::size_t most = block_size / record_size_;
  const auto is_in = [&](const Seen& seen) {
    return (seen.*part).low <= rows.high && (seen.*part).high >= rows.low;
  };
  for (std::size_t first = 0; first < seen_count_; ++first) {
    if (!is_in(seen_[first])) continue;
    std::size_t end = first + 1;
    while (end < seen_count_ && end - first < most && seen_[end].level == seen_[first].level &&
           seen_[end].figure == seen_[first].figure && is_in(seen_[end]))
      ++end;
    glBindBufferRange(GL_UNIFORM_BUFFER, static_cast<GLuint>(Block::Avatars), records_.get(),
                      static_cast<GLintptr>(first * record_size_ * sizeof(Vec4)), block_bytes);
    draw(seen_[first], static_cast<GLsizei>(end - first));
    first = end - 1;
  }
}

void AvatarPass::draw_level(const Seen& one, std::uint32_t level,
                            GLsizei instances) const noexcept {
  const std::size_t bytes =
      worn_->index_type == GL_UNSIGNED_SHORT ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  const scene::BodyLevels::Run& run = worn_->figure[one.figure][level];
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(run.size), worn_->index_type,
                          buffer_offset(run.first * bytes), instances);
}

void AvatarPass::draw_shadow_atlas() const noexcept {
  glBindFramebuffer(GL_FRAMEBUFFER, atlas_framebuffer_.get());
  glViewport(0, 0, atlas_side, atlas_side);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  shadow_.use();
  glUniform1i(at_.shadow_record_size, static_cast<GLint>(record_size_));
  glBindVertexArray(worn_->array.get());
  draw_batches({-1, 1}, &Seen::shadow, [&](const Seen& one, GLsizei instances) {
    draw_level(one, std::min<std::uint32_t>(one.level + 2, scene::BodyLevels::count - 1),
               instances);
  });
  bind_texture(static_cast<GLuint>(Unit::ShadowAtlas), atlas_.get());
  glGenerateMipmap(GL_TEXTURE_2D);
}

/// From one atlas to the other, which is the one that the floor's passes read.
void AvatarPass::soften_shadows() const noexcept {
  glBindFramebuffer(GL_FRAMEBUFFER, soft_framebuffer_.get());
  soften_.use();
  glUniform1i(at_.soften_record_size, static_cast<GLint>(record_size_));
  glBindVertexArray(no_attributes_.get());
  draw_batches({-1, 1}, &Seen::shadow, [&](const Seen&, GLsizei instances) {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
  });
  bind_texture(static_cast<GLuint>(Unit::ShadowAtlas), soft_atlas_.get());
}

void AvatarPass::prepare(const scene::DrawList& list, const Body& body, Vec3 sun,
                         PixelSize picture) noexcept {
  seen_count_ = 0;
  if (body.figure.empty()) return;
  worn_ = &body;
  record_size_ = (first_matrix_row + 3 * matrices_of(body) + alignment - 1) / alignment * alignment;
  choose(list, sun, picture);
  if (seen_count_ == 0) return;
  send(list);
  glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(Block::Looks), looks_.get());
  draw_shadow_atlas();
  soften_shadows();
}

void AvatarPass::draw_bodies(SceneBuffer::Rows rows) const noexcept {
  if (seen_count_ == 0) return;
  body_.use();
  glUniform1i(at_.body_record_size, static_cast<GLint>(record_size_));
  glBindVertexArray(worn_->array.get());
  draw_batches(rows, &Seen::body, [&](const Seen& one, GLsizei instances) {
    // A museum's own character may have cloth that is seen from both sides.
    const bool both_sides = is_own(one.figure, *worn_);
    if (both_sides) glDisable(GL_CULL_FACE);
    draw_level(one, one.level, instances);
    if (both_sides) glEnable(GL_CULL_FACE);
  });
}

void AvatarPass::draw_shadows(SceneBuffer::Rows rows) const noexcept {
  if (seen_count_ == 0) return;
  decal_.use();
  glUniform1i(at_.decal_record_size, static_cast<GLint>(record_size_));
  glBindVertexArray(no_attributes_.get());
  draw_batches(rows, &Seen::shadow, [&](const Seen&, GLsizei instances) {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
  });
}

}  // namespace docent::gles
