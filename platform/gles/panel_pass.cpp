#include "platform/gles/panel_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "platform/gles/extension.h"
#include "platform/gles/shaders.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::gles {
namespace {

bool is_sideways(Rotation rotation) noexcept {
  return rotation == Rotation::Quarter || rotation == Rotation::ThreeQuarters;
}

Region all_of(PixelSize size) noexcept {
  return {0, 0, static_cast<GLint>(size.width), static_cast<GLint>(size.height)};
}

/// As shares of the picture, whose y runs up.
Vec2 shift_of(const RenderTarget& target) noexcept {
  return {static_cast<double>(target.shift_x) / target.size.width,
          -static_cast<double>(target.shift_y) / target.size.height};
}

}  // namespace

Result<void> PanelPass::compile() {
  const bool is_read_encoded = can_read_encoded();
  if (is_read_encoded) picture_ = Picture(GL_NEAREST, Picture::Read::Encoded);
  auto program = link_program("copy", {shaders::copy_vert},
                              {is_read_encoded ? shaders::as_it_is_frag : shaders::copy_frag});
  if (!program) return std::unexpected(program.error());
  program_ = std::move(*program);
  quarter_turns_ = program_["quarter_turns"];
  shift_ = program_["shift"];
  array_ = make_vertex_array();
  return {};
}

GLuint PanelPass::picture(PixelSize size) noexcept {
  picture_.fit(size);
  return picture_.framebuffer();
}

Region PanelPass::stale(std::uint32_t age) const noexcept {
  if (age == 0 || age >= copies_ || age > changed_.size()) return all_of(copied_to_.size);
  Region stale;
  for (std::uint32_t i = 0; i < age; ++i) stale.include(changed_[i]);
  return stale;
}

void PanelPass::copy(const RenderTarget& target, const Region& changed,
                     std::uint32_t age) noexcept {
  if (target != copied_to_) forget();
  copied_to_ = target;
  std::ranges::move_backward(changed_.begin(), changed_.end() - 1, changed_.end());
  changed_.front() = changed;
  ++copies_;
  const PixelSize panel = panel_size(target);
  const Region lacking = common(on_panel(stale(age), target), all_of(panel));
  if (lacking.is_empty()) return;
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, static_cast<GLsizei>(panel.width), static_cast<GLsizei>(panel.height));
  glEnable(GL_SCISSOR_TEST);
  glScissor(lacking.left, lacking.low, lacking.right - lacking.left, lacking.high - lacking.low);
  glDisable(GL_BLEND);
  program_.use();
  glUniform1i(quarter_turns_, static_cast<GLint>(target.rotation));
  const Vec2 shift = shift_of(target);
  glUniform2f(shift_, static_cast<float>(shift.x), static_cast<float>(shift.y));
  bind_texture(static_cast<GLuint>(Unit::Image), picture_.texture());
  glBindVertexArray(array_.get());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_SCISSOR_TEST);
}

PixelSize panel_size(const RenderTarget& target) noexcept {
  return is_sideways(target.rotation) ? PixelSize{target.size.height, target.size.width}
                                      : target.size;
}

/// As copy.vert has it, the other way round.
Region on_panel(const Region& part, const RenderTarget& target) noexcept {
  if (part.is_empty()) return {};
  const PixelSize panel = panel_size(target);
  const GLint across = std::abs(target.shift_x), down = std::abs(target.shift_y);
  const Vec2 shift = shift_of(target);
  const auto place = [&](GLint x, GLint y) {
    Vec2 p = Vec2{static_cast<double>(x) / target.size.width,
                  static_cast<double>(y) / target.size.height} -
             0.5 + shift;
    for (int turn = 0; turn < static_cast<int>(target.rotation); ++turn) p = left_of(p);
    return (p + 0.5) * Vec2{panel.width, panel.height};
  };
  const Vec2 a = place(part.left - across, part.low - down);
  const Vec2 b = place(part.right + across, part.high + down);
  return {static_cast<GLint>(std::floor(std::min(a.x, b.x))) - 1,
          static_cast<GLint>(std::floor(std::min(a.y, b.y))) - 1,
          static_cast<GLint>(std::ceil(std::max(a.x, b.x))) + 1,
          static_cast<GLint>(std::ceil(std::max(a.y, b.y))) + 1};
}

}  // namespace docent::gles
