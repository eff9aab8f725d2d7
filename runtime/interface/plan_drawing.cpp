#include "runtime/interface/plan_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/model/geometry/segment.h"

namespace docent::interface {
namespace {

/// The colours of the theme, as pictures have them.

struct Box {
  Vec2 least{std::numeric_limits<double>::infinity()};
  Vec2 most{-std::numeric_limits<double>::infinity()};
  void add(Vec2 p) noexcept {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
};

Box seen_box(const FloorPlan& plan, const PlanFrame& frame) noexcept {
  Box box;
  for (const Vec2 v : plan.vertex) box.add(frame.pixel(v));
  if (plan.vertex.empty()) box = {{0, 0}, {1, 1}};
  return box;
}

PlanFrame turned(double heading) noexcept {
  const Vec2 up{std::cos(heading), std::sin(heading)};
  return {.right = -left_of(up), .down = -up};
}

/// How much of each pixel a shape covers.
class Mask {
 public:
  Mask(std::uint32_t width, std::uint32_t height)
      : width_(static_cast<long>(width)),
        height_(static_cast<long>(height)),
        cover_(std::size_t{width} * height, 0.0F) {}

  float at(std::size_t pixel) const noexcept { return cover_[pixel]; }

  void stroke(Vec2 a, Vec2 b, double radius) {
    const Vec2 reach(radius + 1);
    paint(glm::min(a, b) - reach, glm::max(a, b) + reach,
          [&](Vec2 p) { return radius + 0.5 - distance_to_segment(p, a, b); });
  }
  void line(std::span<const Vec2> points, double radius) {
    for (std::size_t i = 1; i < points.size(); ++i) stroke(points[i - 1], points[i], radius);
  }
  void ring(Vec2 middle, double radius, double half_width) {
    const Vec2 reach(radius + half_width + 1);
    paint(middle - reach, middle + reach,
          [&](Vec2 p) { return half_width + 0.5 - std::abs(glm::distance(p, middle) - radius); });
  }
  /// A triangle, corners in either sense.
  void triangle(const std::array<Vec2, 3>& corner) {
    const Vec2 reach(1);
    const double turn = cross(corner[1] - corner[0], corner[2] - corner[0]) < 0 ? -1 : 1;
    paint(glm::min(glm::min(corner[0], corner[1]), corner[2]) - reach,
          glm::max(glm::max(corner[0], corner[1]), corner[2]) + reach, [&](Vec2 p) {
            double inside = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < 3; ++i) {
              const Vec2 side = corner[(i + 1) % 3] - corner[i];
              inside = std::min(inside, turn * cross(side, p - corner[i]) / glm::length(side));
            }
            return inside + 0.5;
          });
  }
  /// The inside of rings, by the even-odd rule: four lines of each row of pixels.
  void rings(const FloorPlan& plan, const PlanFrame& frame) {
    constexpr int lines = 4;
    std::vector<double> crossings;
    for (long row = 0; row < height_; ++row)
      for (int line = 0; line < lines; ++line) {
        const double y = static_cast<double>(row) + (line + 0.5) / lines;
        crossings.clear();
        for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall) {
          const Vec2 a = frame.pixel(wall_start(plan, wall)), b = frame.pixel(wall_end(plan, wall));
          if ((a.y > y) != (b.y > y))
            crossings.push_back(std::lerp(a.x, b.x, (y - a.y) / (b.y - a.y)));
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
          span(row, crossings[i], crossings[i + 1], 1.0F / lines);
      }
  }

 private:
  void paint(Vec2 least, Vec2 most, auto&& coverage) {
    const long left = std::max(0L, std::lround(std::floor(std::max(least.x, 0.0))));
    const long top = std::max(0L, std::lround(std::floor(std::max(least.y, 0.0))));
    const long right = std::min(width_ - 1, std::lround(std::clamp(most.x, -1.0, 1e6)));
    const long bottom = std::min(height_ - 1, std::lround(std::clamp(most.y, -1.0, 1e6)));
    for (long y = top; y <= bottom; ++y)
      for (long x = left; x <= right; ++x) {
        float& cover = cover_[static_cast<std::size_t>(y * width_ + x)];
        const Vec2 middle{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
        cover = std::max(cover, static_cast<float>(std::clamp(coverage(middle), 0.0, 1.0)));
      }
  }
  void span(long row, double from, double to, float weight) {
    const long first = std::clamp(std::lround(std::floor(from)), 0L, width_);
    const long last = std::clamp(std::lround(std::ceil(to)), 0L, width_);
    for (long x = first; x < last; ++x) {
      const double begin = std::max(from, static_cast<double>(x));
      const double end = std::min(to, static_cast<double>(x) + 1);
      cover_[static_cast<std::size_t>(row * width_ + x)] +=
          weight * static_cast<float>(std::max(0.0, end - begin));
    }
  }

  long width_, height_;
  std::vector<float> cover_;
};

void lay_over(Pixels& pixels, const Mask& mask, std::uint32_t colour, float opacity = 1) {
  for (std::size_t i = 0; i < std::size_t{pixels.width} * pixels.height; ++i) {
    const float over = std::min(1.0F, mask.at(i)) * opacity;
    if (over <= 0) continue;
    std::byte* pixel = &pixels.rgba[4 * i];
    const float below = static_cast<float>(std::to_integer<int>(pixel[3])) / 255 * (1 - over);
    const float alpha = over + below;
    for (unsigned c = 0; c < 3; ++c) {
      const auto wanted = static_cast<float>(colour >> (16 - 8 * c) & 0xFFU);
      const auto had = static_cast<float>(std::to_integer<int>(pixel[c]));
      pixel[c] = static_cast<std::byte>(std::lround((wanted * over + had * below) / alpha));
    }
    pixel[3] = static_cast<std::byte>(std::lround(255 * alpha));
  }
}

/// Where one stands, and what one sees: ahead is up.
void draw_whereabouts(Pixels& pixels, Vec2 at, const PlanColours& colours, double unit) {
  const auto fresh = [&] { return Mask(pixels.width, pixels.height); };
  Mask view = fresh(), rim = fresh(), mark = fresh();
  view.triangle({at, at + Vec2{-2.6, -4.2} * unit, at + Vec2{2.6, -4.2} * unit});
  lay_over(pixels, view, colours.ink, 0.28F);
  const std::array<Vec2, 3> arrow{at + Vec2{0, -2.3} * unit, at + Vec2{-1.35, 0.2} * unit,
                                  at + Vec2{1.35, 0.2} * unit};
  rim.stroke(at, at, 1.55 * unit);
  lay_over(pixels, rim, colours.paper);
  mark.triangle(arrow);
  mark.stroke(at, at, 1.2 * unit);
  lay_over(pixels, mark, colours.ink);
}

}  // namespace

double aspect_of(const FloorPlan& plan, double heading) noexcept {
  const Box box = seen_box(plan, turned(heading));
  const Vec2 size = glm::max(box.most - box.least, Vec2(1e-3));
  return size.x / size.y;
}

PlanFrame frame_of(const FloorPlan& plan, double heading, const DrawingShape& shape) noexcept {
  PlanFrame frame = turned(heading);
  const Box box = seen_box(plan, frame);
  const Vec2 size = glm::max(box.most - box.least, Vec2(1e-3));
  const Vec2 room = shape.plan_most - shape.plan_least;
  frame.scale = std::min(room.x / size.x, room.y / size.y);
  const Vec2 middle = (box.least + box.most) / 2.0;
  const Vec2 corner = middle - (shape.plan_least + shape.plan_most) / (2 * frame.scale);
  frame.origin = corner.x * frame.right + corner.y * frame.down;
  return frame;
}

Pixels draw_plan(const PlanDrawing& drawing) {
  const auto& [plan, frame, shape, way, way_colour, is_cased, colours, here, compass, unit] =
      drawing;
  Pixels pixels{shape.width, shape.height,
                std::vector<std::byte>(std::size_t{4} * shape.width * shape.height)};
  const auto fresh = [&] { return Mask(shape.width, shape.height); };

  Mask ground = fresh();
  ground.rings(plan, frame);
  lay_over(pixels, ground, colours.floor);
  Mask walls = fresh();
  for (std::uint32_t wall = 0; wall < plan.vertex.size(); ++wall)
    walls.stroke(frame.pixel(wall_start(plan, wall)), frame.pixel(wall_end(plan, wall)),
                 0.08 * unit);
  lay_over(pixels, walls, colours.wall);

  std::vector<Vec2> line;
  for (const Vec2 point : way) line.push_back(frame.pixel(point));
  if (line.size() > 1) {
    Mask casing = fresh(), stroke = fresh(), end = fresh();
    casing.line(line, 0.5 * unit);
    casing.ring(line.back(), 0.9 * unit, 0.5 * unit);
    lay_over(pixels, casing, is_cased ? colours.ink : colours.paper);
    stroke.line(line, 0.34 * unit);
    end.stroke(line.back(), line.back(), 1.1 * unit);
    lay_over(pixels, stroke, way_colour);
    lay_over(pixels, end, way_colour);
    Mask eye = fresh();
    eye.stroke(line.back(), line.back(), 0.45 * unit);
    lay_over(pixels, eye, colours.paper);
  }

  if (here) draw_whereabouts(pixels, frame.pixel(*here), colours, unit);

  const Vec2 north{frame.right.y, frame.down.y};  // where y grows on the drawing
  const Vec2 aside{-north.y, north.x};
  Mask arrowhead = fresh(), circle = fresh();
  constexpr double rim = 2.3, tip = 3.5;  // units: a letter of 5 mm is within
  circle.ring(compass, rim * unit, 0.06 * unit);
  lay_over(pixels, circle, colours.wall);
  arrowhead.triangle({compass + tip * unit * north, compass + (rim * north + 0.8 * aside) * unit,
                      compass + (rim * north - 0.8 * aside) * unit});
  lay_over(pixels, arrowhead, colours.ink);
  return pixels;
}

}  // namespace docent::interface
