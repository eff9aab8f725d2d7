#include "platform/gles/way_pass.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "platform/gles/shaders.h"
#include "runtime/scene/look.h"

namespace docent::gles {
namespace {

constexpr std::size_t most_vertices = 32768;
constexpr std::size_t most_points = 16384;
constexpr float ribbon_lift = 0.012F;  // metres above the floor; markers lie a little higher
constexpr float marker_lift = 0.02F;

}  // namespace

Result<void> WayPass::compile() {
  using namespace shaders;
  auto ribbon =
      link_program("ribbon", {frame_glsl, ribbon_vert}, {frame_glsl, light_glsl, ribbon_frag});
  if (!ribbon) return std::unexpected(ribbon.error());
  auto marker =
      link_program("marker", {frame_glsl, marker_vert}, {frame_glsl, light_glsl, marker_frag});
  if (!marker) return std::unexpected(marker.error());
  ribbon_ = std::move(*ribbon);
  marker_ = std::move(*marker);
  at_ = {ribbon_["lift"],  ribbon_["tone"], ribbon_["way"],  ribbon_["pattern"],
         marker_["place"], marker_["tone"], marker_["mark"], marker_["inner_tone"]};

  staging_.reserve(most_vertices);
  rounded_.reserve(most_points);
  no_attributes_ = make_vertex_array();
  array_ = make_vertex_array();
  glBindVertexArray(array_.get());
  vertices_ = make_buffer();
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  glBufferData(GL_ARRAY_BUFFER, most_vertices * sizeof(scene::RibbonVertex), nullptr,
               GL_DYNAMIC_DRAW);
  for (GLuint i = 0; i < 2; ++i) glEnableVertexAttribArray(i);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(scene::RibbonVertex),
                        buffer_offset(offsetof(scene::RibbonVertex, place)));
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(scene::RibbonVertex),
                        buffer_offset(offsetof(scene::RibbonVertex, ribbon)));
  return {};
}

bool WayPass::is_current(const scene::DrawList& list) const noexcept {
  const std::size_t count = std::min(list.ribbons.size(), most_ribbons);
  return count == strip_count_ &&
         std::equal(strips_.begin(), strips_.begin() + static_cast<std::ptrdiff_t>(count),
                    list.ribbons.begin(), [](const Strip& strip, const scene::RibbonDraw& ribbon) {
                      return strip.revision == ribbon.revision &&
                             strip.first_point == ribbon.first && strip.point_count == ribbon.count;
                    });
}

void WayPass::prepare(const scene::DrawList& list) noexcept {
  if (is_current(list)) return;
  staging_.clear();
  strip_count_ = std::min(list.ribbons.size(), most_ribbons);
  for (std::size_t i = 0; i < strip_count_; ++i) {
    const scene::RibbonDraw& ribbon = list.ribbons[i];
    const std::size_t first = std::min<std::size_t>(ribbon.first, list.ribbon_point.size());
    const std::size_t count = std::min<std::size_t>(ribbon.count, list.ribbon_point.size() - first);
    const auto before = static_cast<GLint>(staging_.size());
    const std::size_t made = scene::append_ribbon(
        std::span(list.ribbon_point).subspan(first, count), ribbon.length, rounded_, staging_);
    strips_[i] = {ribbon.revision, ribbon.first, ribbon.count, before, static_cast<GLsizei>(made)};
  }
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
  glBufferSubData(GL_ARRAY_BUFFER, 0,
                  static_cast<GLsizeiptr>(staging_.size() * sizeof(scene::RibbonVertex)),
                  staging_.data());
}

void WayPass::draw_ribbon(const scene::RibbonDraw& ribbon, const Strip& strip,
                          float least) const noexcept {
  const scene::Colour own =
      ribbon.look ? scene::trail_colour(*ribbon.look) : scene::route_colour(ribbon.kind);
  const scene::Colour tone = scene::lifted(own, least);
  set(at_.tone, scene::with_opacity(tone, ribbon.opacity));
  glUniform4f(at_.way, ribbon.length, ribbon.walked, ribbon.flow,
              static_cast<float>(scene::ribbon_half_width));
  const LinePattern& pattern = info_of(ribbon.kind).pattern;
  glUniform2f(at_.pattern, pattern.period, pattern.piece / 2);
  glDrawArrays(GL_TRIANGLE_STRIP, strip.first, strip.count);
}

void WayPass::draw_marker(const scene::MarkerDraw& marker,
                          const scene::Light& light) const noexcept {
  using Kind = scene::MarkerDraw::Kind;
  const bool is_exhibit = marker.kind == Kind::Exhibit;
  scene::Colour tone = is_exhibit ? theme_.quiet_ink : light.mark;
  if (marker.look) tone = scene::trail_colour(*marker.look);
  if (!is_exhibit) tone = scene::lifted(tone, light.least_way);
  if (marker.kind == Kind::Doorway) tone = light.doorway;
  set(at_.marker_tone, scene::with_opacity(tone, marker.opacity));
  set(at_.inner_tone, theme_.paper);
  const float half = marker.kind == Kind::YouAreHere
                         ? 2.7F * marker.radius  // as marker.frag has it
                     : marker.kind == Kind::Doorway ? std::max(marker.radius, 1.2F)
                                                    : 1.3F * marker.radius;
  glUniform4f(at_.place, marker.position.x, marker.position.y + marker_lift, marker.position.z,
              half);
  glUniform4f(at_.mark, marker.radius, std::cos(marker.heading), std::sin(marker.heading),
              static_cast<float>(marker.kind));
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

Extent WayPass::extent_of_ribbons(const scene::DrawList& list, double floor) noexcept {
  constexpr double beside = scene::ribbon_half_width + scene::ribbon_rim;
  const Mat4 to_clip = list.camera.projection * list.camera.view;
  Extent extent;
  for (const scene::RibbonDraw& ribbon : list.ribbons) {
    const std::size_t first = std::min<std::size_t>(ribbon.first, list.ribbon_point.size());
    const std::size_t count = std::min<std::size_t>(ribbon.count, list.ribbon_point.size() - first);
    for (const Vec2 point : std::span(list.ribbon_point).subspan(first, count))
      for (const Vec2 corner : {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, -1), Vec2(1, 1)})
        extent.include(to_clip, to_world(point + 2 * beside * corner, floor));
  }
  return extent;
}

void WayPass::draw_markers(const scene::DrawList& list, bool are_doors) const noexcept {
  marker_.use();
  glBindVertexArray(no_attributes_.get());
  for (const scene::MarkerDraw& marker : list.markers)
    if (marker.opacity > 0 && (marker.kind == scene::MarkerDraw::Kind::Doorway) == are_doors)
      draw_marker(marker, list.light);
}

/// The light in doorways lies under the way, and every mark on it.
void WayPass::draw(const scene::DrawList& list) const noexcept {
  draw_markers(list, true);
  ribbon_.use();
  glUniform1f(at_.lift, ribbon_lift);
  glBindVertexArray(array_.get());
  for (std::size_t i = 0; i < strip_count_; ++i)
    if (strips_[i].count > 0 && list.ribbons[i].opacity > 0)
      draw_ribbon(list.ribbons[i], strips_[i], list.light.least_way);
  draw_markers(list, false);
}

}  // namespace docent::gles
