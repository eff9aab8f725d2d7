#pragma once

#include <array>
#include <vector>

#include "platform/gles/extent.h"
#include "platform/gles/program.h"
#include "runtime/scene/ribbon_mesh.h"
#include "runtime/scene/theme.h"

namespace docent::gles {

/// Draws the way on the floor: ribbons and markers.
class WayPass {
 public:
  /// More ribbons than this are not drawn.
  static constexpr std::size_t most_ribbons = 8;

  Result<void> compile();
  /// Rebuilds the triangle strips of ribbons whose revision has changed. Called before the first
  /// strip of the picture.
  void prepare(const scene::DrawList& list) noexcept;
  void draw(const scene::DrawList& list) const noexcept;
  /// Where the ribbons are in the picture; `floor`: world y.
  static Extent extent_of_ribbons(const scene::DrawList& list, double floor) noexcept;

 private:
  struct Strip {
    std::uint32_t revision = 0, first_point = 0, point_count = 0;
    GLint first = 0;
    GLsizei count = 0;
  };
  bool is_current(const scene::DrawList& list) const noexcept;
  void draw_ribbon(const scene::RibbonDraw& ribbon, const Strip& strip, float least) const noexcept;
  void draw_markers(const scene::DrawList& list, bool are_doors) const noexcept;
  void draw_marker(const scene::MarkerDraw& marker, const scene::Light& light) const noexcept;

  GlBuffer vertices_;
  GlVertexArray array_, no_attributes_;
  std::vector<scene::RibbonVertex> staging_;
  std::vector<Vec2> rounded_;
  std::array<Strip, most_ribbons> strips_{};
  std::size_t strip_count_ = 0;
  Program ribbon_, marker_;
  struct {
    GLint lift, tone, way, pattern, place, marker_tone, mark, inner_tone;
  } at_{};
  scene::Theme theme_;
};

}  // namespace docent::gles
