#include "content/command/plan_sketch.h"

#include <fmt/format.h>

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

}  // namespace

std::string sketch_plan(const FloorPlan& plan, const std::vector<SketchLine>& lines) {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  for (const Vec2 vertex : plan.vertex) {
    low = glm::min(low, vertex);
    high = glm::max(high, vertex);
  }
  if (plan.vertex.empty()) low = high = {0, 0};
  const double margin = 0.02 * glm::length(high - low) + 0.1;
  const Vec2 size = high - low + Vec2{2 * margin, 2 * margin};
  const double stroke = glm::length(size) / 500;

  std::string walls;
  for (const Ring& ring : plan.ring)
    walls += path_data(
        {plan.vertex.begin() + ring.first, plan.vertex.begin() + ring.first + ring.count}, true);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0:.4f} {1:.4f} {2:.4f} {3:.4f}\" "
      "width=\"1200\">\n"
      "<rect x=\"{0:.4f}\" y=\"{1:.4f}\" width=\"{2:.4f}\" height=\"{3:.4f}\" fill=\"#fff\"/>\n"
      "<path d=\"{4}\" fill=\"#f6f1e7\" fill-rule=\"evenodd\" stroke=\"#3b3a36\" "
      "stroke-width=\"{5:.4f}\" stroke-linejoin=\"round\"/>\n",
      low.x - margin, -high.y - margin, size.x, size.y, walls, stroke);
  for (const SketchLine& line : lines) {
    if (line.points.empty()) continue;
    svg += fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"#b4532a\" stroke-width=\"{:.4f}\" "
        "stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
        path_data(line.points, line.closed), 2 * stroke);
    if (line.closed) continue;
    for (const Vec2 end : {line.points.front(), line.points.back()})
      svg += fmt::format("<circle cx=\"{:.4f}\" cy=\"{:.4f}\" r=\"{:.4f}\" fill=\"#b4532a\"/>\n",
                         end.x, -end.y, 3 * stroke);
  }
  return svg + "</svg>\n";
}

}  // namespace docent::command
