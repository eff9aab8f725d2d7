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
  is_read_encoded_ = can_read_encoded();
  if (is_read_encoded_) picture_ = Picture(GL_NEAREST, Picture::Read::Encoded);
  auto program = link_program("copy", {shaders::copy_vert},
                              {is_read_encoded_ ? shaders::as_it_is_frag : shaders::copy_frag});
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
  if (age == 0 || age >= copies_ || age > changed_.size()) return all_of(target_.size);
  Region stale;
  for (std::uint32_t i = 0; i < age; ++i) stale.include(changed_[i]);
  return stale;
}

Region PanelPass::lacking(const RenderTarget& target, const Region& changed,
                          std::uint32_t age) noexcept {
  if (target != target_) forget();
  target_ = target;
  std::ranges::move_backward(changed_.begin(), changed_.end() - 1, changed_.end());
  changed_.front() = changed;
  ++copies_;
  return stale(age);
}

void PanelPass::copy_of(GLuint texture, const Region& part) noexcept {
  const Region there = on_panel(part, target_);
  if (there.is_empty()) return;
  const PixelSize panel = panel_size(target_);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer);
  glViewport(0, 0, static_cast<GLsizei>(panel.width), static_cast<GLsizei>(panel.height));
  glEnable(GL_SCISSOR_TEST);
  glScissor(there.left, there.low, there.right - there.left, there.high - there.low);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  program_.use();
  glUniform1i(quarter_turns_, static_cast<GLint>(target_.rotation));
  const Vec2 shift = shift_of(target_);
  glUniform2f(shift_, static_cast<float>(shift.x), static_cast<float>(shift.y));
  bind_texture(static_cast<GLuint>(Unit::Image), texture);
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
  const Region all = all_of(target.size);
  const GLint across = std::abs(target.shift_x), down = std::abs(target.shift_y);
  const Vec2 shift = shift_of(target);
  const auto place = [&](GLint x, GLint y) {
    Vec2 p = Vec2{static_cast<double>(x) / target.size.width,
                  static_cast<double>(y) / target.size.height} -
             0.5 + shift;
    for (int turn = 0; turn < static_cast<int>(target.rotation); ++turn) p = left_of(p);
    return (p + 0.5) * Vec2{panel.width, panel.height};
  };
  const Vec2 a = place(part.left - (part.left == all.left ? across : 0),
                       part.low - (part.low == all.low ? down : 0));
  const Vec2 b = place(part.right + (part.right == all.right ? across : 0),
                       part.high + (part.high == all.high ? down : 0));
  const auto pixel = [](double at) { return static_cast<GLint>(std::lround(at)); };
  return common({pixel(std::min(a.x, b.x)), pixel(std::min(a.y, b.y)), pixel(std::max(a.x, b.x)),
                 pixel(std::max(a.y, b.y))},
                all_of(panel));
}

}  // namespace docent::gles
