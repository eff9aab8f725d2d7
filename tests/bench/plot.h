#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {

/// One thing that was measured: faint dots, and a line with marks through what is to be compared.
struct Series {
  enum class Mark : std::uint8_t { Disc, Ring, Square, Diamond };
  std::string name;
  std::string colour;  ///< "#RRGGBB".
  Mark mark = Mark::Disc;
  std::string label{};  ///< At the line's end; empty for the name.
  std::vector<Vec2> dots{};
  std::vector<Vec2> line{};  ///< In the order of x.
  bool is_dashed = false;    ///< For lines that were not measured: a fit, a goal.
};

/// A diagram with two logarithmic axes. All coordinates are positive.
struct Panel {
  std::string title;
  std::string x_title, y_title;
  std::vector<Series> series;
};

/// Panels side by side under a heading, with a legend and with each line's label at its end: a
/// whole SVG document.
std::string draw_panels(const std::string& heading, const std::string& note,
                        const std::vector<Panel>& panels);

/// Medians of dots in bins of x, each twice as wide as the one before: what the lines show when
/// there are many dots. A bin of fewer than `least` dots gives none.
std::vector<Vec2> medians_by_octave(const std::vector<Vec2>& dots, std::size_t least = 1);

}  // namespace docent::bench
