#include "content/compile/check_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "runtime/model/none.h"

namespace docent::compile {

namespace {

struct Extent {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};

  Vec2 size() const { return high - low; }
  double longest() const { return std::max(size().x, size().y); }
};

Extent extent_of(const std::vector<Vec2>& points) {
  Extent box;
  for (const Vec2 p : points) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}

/// A unit that plans are drawn in: how many there are in a metre.
struct Unit {
  std::string_view name;
  double in_a_metre;
};
constexpr std::array<Unit, 4> units{
    {{"millimetres", 1000}, {"centimetres", 100}, {"inches", 39.3701}, {"feet", 3.28084}}};

/// How far two boxes are from being the same, as a share of their size.
double difference(const Extent& a, const Extent& b) {
  const Vec2 low = glm::abs(a.low - b.low), high = glm::abs(a.high - b.high);
  return std::max({low.x, low.y, high.x, high.y}) / std::max(a.longest(), b.longest());
}

std::string size_text(const Extent& box) {
  return fmt::format("{:.0f} m by {:.0f} m", box.size().x, box.size().y);
}

}  // namespace

std::optional<ScaleDoubt> scale_doubt(const std::vector<Vec2>& plan,
                                      const std::vector<Vec2>& things) {
  constexpr std::size_t enough = 8;  // the corners of two rooms
  constexpr double nearly = 0.25, alike = 0.1;
  if (plan.empty() || things.size() < enough) return {};
  const Extent drawn = extent_of(plan), said = extent_of(things);
  if (said.longest() <= 0 || drawn.longest() <= 0) return {};
  const double ratio = drawn.longest() / said.longest();
  for (const Unit& unit : units)
    if (std::abs(std::log(ratio / unit.in_a_metre)) < nearly)
      return ScaleDoubt{
          fmt::format("it is {} large, and all that stands on it {}: it seems to be drawn in {}",
                      size_text(drawn), size_text(said), unit.name),
          fmt::format("export it in metres, or divide its numbers by {:g}", unit.in_a_metre)};
  const Vec2 apart = drawn.low - said.low;
  const bool meet = drawn.low.x <= said.high.x && said.low.x <= drawn.high.x &&
                    drawn.low.y <= said.high.y && said.low.y <= drawn.high.y;
  if (!meet)
    return ScaleDoubt{
        fmt::format(
            "it lies about [{:.0f}, {:.0f}], and all that stands on it about [{:.0f}, {:.0f}]",
            (drawn.low.x + drawn.high.x) / 2, (drawn.low.y + drawn.high.y) / 2,
            (said.low.x + said.high.x) / 2, (said.low.y + said.high.y) / 2),
        fmt::format("move the plan by [{:.0f}, {:.0f}]", -apart.x, -apart.y)};
  const Extent turned{{drawn.low.y, drawn.low.x}, {drawn.high.y, drawn.high.x}};
  if (difference(drawn, said) > alike && difference(turned, said) <= alike)
    return ScaleDoubt{"its two axes seem to be swapped: what stands on it would fit it turned over",
                      "write each point as [east, north]"};
  return {};
}

}  // namespace docent::compile
