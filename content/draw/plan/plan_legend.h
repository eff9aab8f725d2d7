#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "content/draw/plan/plan_drawing.h"
#include "content/draw/svg.h"

namespace docent::draw {

/// Says what the colours and lines of a drawn plan mean, in rows below it.
class PlanLegend {
 public:
  /// Has an entry for each colour of what is not floor, for each layer that needs words and for
  /// each kind of line.
  PlanLegend(const FloorPlan& plan, const PlanLayers& layers, const std::vector<DrawnLine>& lines);

  /// Pixels that the rows take on a page that leaves them this width.
  [[nodiscard]] double height(double width) const;
  /// Draws the rows, their upper left corner at `at`.
  void draw(Svg& svg, Vec2 at, double width) const;

 private:
  enum class Symbol : std::uint8_t {
    Wall,
    Case,
    Block,
    OpenDoor,
    ClosedDoor,
    Regions,
    MedialAxis,
    WallSites,
    Levels,
    Corner,
    Stop,
    Way,
    OffsetCurve,
  };
  struct Entry {
    Symbol symbol;
    std::string words;
    RouteKind kind = RouteKind::Shortest;  ///< Of a way.
  };

  void add_walls(const FloorPlan& plan);
  void add_lines(const std::vector<DrawnLine>& lines);
  [[nodiscard]] std::vector<Vec2> places(double width) const;
  static void draw_symbol(Svg& svg, const Entry& entry, Vec2 at);

  std::vector<Entry> entries_;
};

}  // namespace docent::draw
