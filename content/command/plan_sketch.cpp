#include "content/command/plan_sketch.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/model/none.h"

namespace docent::command {
namespace {

/// SVG's y runs down, the floor's north.
std::string path_data(const std::vector<Vec2>& points, bool closed) {
  std::string data;
  for (const Vec2 point : points)
    data += fmt::format("{}{:.4f} {:.4f}", data.empty() ? "M" : "L", point.x, -point.y);
  return closed ? data + "Z" : data;
}

struct Box {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
};

Box box_about(std::span<const FloorSketch> floors) {
  Box box;
  for (const FloorSketch& floor : floors)
    for (const Vec2 vertex : floor.plan.vertex) {
      box.low = glm::min(box.low, vertex);
      box.high = glm::max(box.high, vertex);
    }
  if (box.low.x > box.high.x) return {{0, 0}, {0, 0}};
  return box;
}

std::string drawn_walls(const FloorPlan& plan, double stroke) {
  std::string walls;
  for (const Ring& ring : plan.ring)
    walls += path_data(
        {plan.vertex.begin() + ring.first, plan.vertex.begin() + ring.first + ring.count}, true);
  return fmt::format(
      "<path d=\"{}\" fill=\"#f6f1e7\" fill-rule=\"evenodd\" stroke=\"#3b3a36\" "
      "stroke-width=\"{:.4f}\" stroke-linejoin=\"round\"/>\n",
      walls, stroke);
}

std::string drawn_line(const SketchLine& line, double stroke) {
  if (line.points.empty()) return {};
  std::string svg = fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"#b4532a\" stroke-width=\"{:.4f}\" "
      "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
      path_data(line.points, line.closed), 2 * stroke);
  if (line.closed) return svg;
  for (const Vec2 end : {line.points.front(), line.points.back()})
    svg += fmt::format("<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\" fill=\"#b4532a\"/>\n",
                       end.x, -end.y, 3 * stroke);
  return svg;
}

}  // namespace

std::string sketch_plans(std::span<const FloorSketch> floors) {
  const Box box = box_about(floors);
  const Vec2 extent = box.high - box.low;
  const double margin = 0.02 * glm::length(extent) + 0.1;
  const double step = extent.x + 2 * margin;
  const Vec2 size{step * static_cast<double>(floors.size()), extent.y + 2 * margin};
  const double stroke = glm::length(extent + Vec2{2 * margin, 2 * margin}) / 500;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0:.4f} {1:.4f} {2:.4f} {3:.4f}\" "
      "width=\"{4}\">\n"
      "<rect x=\"{0:.4f}\" y=\"{1:.4f}\" width=\"{2:.4f}\" height=\"{3:.4f}\" fill=\"#fff\"/>\n",
      box.low.x - margin, -box.high.y - margin, size.x, size.y, 1200 * floors.size());
  for (std::size_t i = 0; i < floors.size(); ++i) {
    svg += fmt::format("<g transform=\"translate({:.4f} 0)\">\n", step * static_cast<double>(i));
    svg += drawn_walls(floors[i].plan, stroke);
    for (const SketchLine& line : floors[i].lines) svg += drawn_line(line, stroke);
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

std::string sketch_plan(const FloorPlan& plan, std::vector<SketchLine> lines) {
  const FloorSketch floor{plan, std::move(lines)};
  return sketch_plans(std::span(&floor, 1));
}

}  // namespace docent::command
