#include "platform/gles/quad_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "platform/gles/shaders.h"
#include "runtime/scene/side.h"

namespace docent::gles {
namespace {

constexpr int sides_step = 8;                 // between the kinds of two sides, as in quad.vert
constexpr std::size_t most_instances = 1024;  // a batch; longer lists take several

bool uses_texture(scene::QuadFill fill) noexcept {
  return fill == scene::QuadFill::Text || fill == scene::QuadFill::Image;
}

/// A text is drawn texel for pixel: on whole pixels, as large as its texture's part.
scene::Rect text_rect(const scene::Quad& quad, PixelSize screen,
                      const Textures::Entry& texture) noexcept {
  float across = std::round(quad.uv.width * static_cast<float>(texture.width));
  float down = std::round(quad.uv.height * static_cast<float>(texture.height));
  if (scene::is_at_end(quad.side)) std::swap(across, down);
  return {std::round(quad.rect.x * static_cast<float>(screen.width)),
          std::round(quad.rect.y * static_cast<float>(screen.height)), across, down};
}

/// `rect`: pixels, y runs down; `beyond`: how far about it something is seen.
bool reaches_into(const Region& part, const scene::Rect& rect, float beyond,
                  float height) noexcept {
  const auto left = static_cast<float>(part.left), right = static_cast<float>(part.right);
  const float top = height - static_cast<float>(part.high);
  const float bottom = height - static_cast<float>(part.low);
  return rect.x - beyond < right && rect.x + rect.width + beyond > left &&
         rect.y - beyond < bottom && rect.y + rect.height + beyond > top;
}

}  // namespace

Result<void> QuadPass::compile() {
  auto program = link_program("quad", {shaders::quad_vert}, {shaders::quad_frag});
  if (!program) return std::unexpected(program.error());
  program_ = std::move(*program);
  screen_ = program_["screen"];
  staging_.reserve(most_instances);
  array_ = make_vertex_array();
  glBindVertexArray(array_.get());
  instances_ = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, instances_.get());
  glBufferData(GL_ARRAY_BUFFER, most_instances * sizeof(Instance), nullptr, GL_STREAM_DRAW);
  for (GLuint i = 0; i < sizeof(Instance) / (4 * sizeof(float)); ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribDivisor(i, 1);
    glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                          buffer_offset(i * 4 * sizeof(float)));
  }
  return {};
}

void QuadPass::flush(GLuint texture) noexcept {
  if (staging_.empty()) return;
  bind_texture(static_cast<GLuint>(Unit::Image), texture);
  const auto bytes = static_cast<GLsizeiptr>(staging_.size() * sizeof(Instance));
  // Orphaned each time: the driver hands out new memory while it still draws from the old.
  glBufferData(GL_ARRAY_BUFFER, bytes, staging_.data(), GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(staging_.size()));
  staging_.clear();
}

void QuadPass::draw(std::span<const scene::Quad> quads, PixelSize screen, const Textures& textures,
                    const Region& part) noexcept {
  if (quads.empty()) return;
  program_.use();
  const auto width = static_cast<float>(screen.width);
  const auto height = static_cast<float>(screen.height);
  const float shorter = std::min(width, height);
  glUniform2f(screen_, width, height);
  glBindVertexArray(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.get());
  GLuint bound = 0;
  for (const scene::Quad& quad : quads) {
    const Textures::Entry* texture = nullptr;
    if (uses_texture(quad.fill)) {
      texture = textures.find(quad.texture);
      if (!texture) continue;
    }
    const scene::Rect rect = quad.fill == scene::QuadFill::Text
                                 ? text_rect(quad, screen, *texture)
                                 : scene::Rect{quad.rect.x * width, quad.rect.y * height,
                                               quad.rect.width * width, quad.rect.height * height};
    const float softness = quad.softness * shorter;
    const float reach = scene::is_at_end(quad.side) ? width : height;  // of its clip
    const auto kind =
        static_cast<float>(static_cast<int>(quad.fill) + sides_step * static_cast<int>(quad.side));
    const float beyond = quad.fill == scene::QuadFill::Text     ? 0
                         : quad.fill == scene::QuadFill::Shadow ? softness
                                                                : 1;
    if (!reaches_into(part, rect, beyond, height)) continue;
    if (texture) {
      if (bound != 0 && bound != texture->texture.get()) flush(bound);
      bound = texture->texture.get();
    }
    if (staging_.size() == most_instances) flush(bound);
    staging_.push_back({{rect.x, rect.y, rect.width, rect.height},
                        {quad.uv.x, quad.uv.y, quad.uv.width, quad.uv.height},
                        {quad.colour.r, quad.colour.g, quad.colour.b, quad.colour.a},
                        {quad.corner * shorter, softness, kind, beyond},
                        {quad.clip.top * reach, quad.clip.bottom * reach,
                         quad.clip.fade_above * reach, quad.clip.fade_below * reach}});
  }
  flush(bound);
}

}  // namespace docent::gles
