#include "runtime/interface/pictogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace docent::interface {
namespace {

/// A pictogram is drawn on a square of 24 by 24, origin top left, y down: shapes are added to it
/// and cut out of it, one after another.
constexpr float grid = 24;

struct Point {
  float x = 0, y = 0;
};
Point operator-(Point a, Point b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
float dot(Point a, Point b) noexcept {
  return a.x * b.x + a.y * b.y;
}

/// A shape is all that is no further than `reach` from its line, its box or its triangle.
struct Shape {
  enum class Form : std::uint8_t { Line, Box, Ring, Triangle };
  Form form = Form::Line;
  Point a, b, c;
  float reach = 0;
  bool cuts = false;
};

constexpr Shape line(float x0, float y0, float x1, float y1, float thick) {
  return {.form = Shape::Form::Line, .a = {x0, y0}, .b = {x1, y1}, .c = {}, .reach = thick / 2};
}
constexpr Shape disc(float x, float y, float radius) {
  return line(x, y, x, y, 2 * radius);
}
constexpr Shape box(float x, float y, float width, float height, float corner = 0.6F) {
  return {.form = Shape::Form::Box,
          .a = {x + width / 2, y + height / 2},
          .b = {width / 2 - corner, height / 2 - corner},
          .c = {},
          .reach = corner};
}
constexpr Shape ring(float x, float y, float radius, float thick) {
  return {.form = Shape::Form::Ring, .a = {x, y}, .b = {radius, 0}, .c = {}, .reach = thick / 2};
}
constexpr Shape triangle(Point a, Point b, Point c) {
  return {.form = Shape::Form::Triangle, .a = a, .b = b, .c = c, .reach = 0.3F};
}
constexpr Shape cut(Shape shape) {
  shape.cuts = true;
  return shape;
}

float distance_to_line(Point p, Point a, Point b) noexcept {
  const Point along = b - a, from = p - a;
  const float square = dot(along, along);
  const float t = square > 0 ? std::clamp(dot(from, along) / square, 0.0F, 1.0F) : 0;
  const Point off{from.x - t * along.x, from.y - t * along.y};
  return std::sqrt(dot(off, off));
}

float distance_to_triangle(Point p, const Shape& s) noexcept {
  const auto side = [p](Point a, Point b) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  const float ab = side(s.a, s.b), bc = side(s.b, s.c), ca = side(s.c, s.a);
  const bool inside = (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  const float edge = std::min({distance_to_line(p, s.a, s.b), distance_to_line(p, s.b, s.c),
                               distance_to_line(p, s.c, s.a)});
  return inside ? -edge : edge;
}

/// Less than 0 inside.
float distance(Point p, const Shape& s) noexcept {
  switch (s.form) {
    case Shape::Form::Line:
      return distance_to_line(p, s.a, s.b) - s.reach;
    case Shape::Form::Box: {
      const float x = std::abs(p.x - s.a.x) - s.b.x, y = std::abs(p.y - s.a.y) - s.b.y;
      return std::hypot(std::max(x, 0.0F), std::max(y, 0.0F)) + std::min(std::max(x, y), 0.0F) -
             s.reach;
    }
    case Shape::Form::Ring: {
      const Point off = p - s.a;
      return std::abs(std::sqrt(dot(off, off)) - s.b.x) - s.reach;
    }
    case Shape::Form::Triangle:
      return distance_to_triangle(p, s) - s.reach;
  }
  return 1;
}

std::array<Shape, 4> man(float x) {
  return {disc(x, 4, 2.1F), box(x - 2.6F, 7, 5.2F, 8, 1.4F), line(x - 1.3F, 13, x - 1.3F, 21, 1.9F),
          line(x + 1.3F, 13, x + 1.3F, 21, 1.9F)};
}
std::array<Shape, 4> woman(float x) {
  return {disc(x, 4, 2.1F), triangle({x, 6.8F}, {x - 3.8F, 16}, {x + 3.8F, 16}),
          line(x - 1.2F, 15, x - 1.2F, 21, 1.8F), line(x + 1.2F, 15, x + 1.2F, 21, 1.8F)};
}

using Shapes = std::vector<Shape>;

Shapes both(std::span<const Shape> one, std::span<const Shape> other, Shapes more) {
  more.insert(more.end(), one.begin(), one.end());
  more.insert(more.end(), other.begin(), other.end());
  return more;
}

Shapes shapes_of_wheelchair() {
  return {ring(9.8F, 15.8F, 5.4F, 1.8F),
          cut(line(12, 9, 19, 13, 4)),
          disc(9, 3.6F, 2.1F),
          line(9.4F, 7.6F, 10, 14, 2.4F),
          line(9.6F, 9.8F, 14.8F, 9.8F, 1.7F),
          line(10, 14, 15.6F, 14, 2.2F),
          line(15.6F, 14, 18.2F, 20, 2.2F),
          line(18.2F, 20, 20.4F, 19.4F, 1.8F)};
}

Shapes shapes_of_stairs(float thick) {
  return {line(2.5F, 20, 7.5F, 20, thick),   line(7.5F, 20, 7.5F, 15, thick),
          line(7.5F, 15, 12.5F, 15, thick),  line(12.5F, 15, 12.5F, 10, thick),
          line(12.5F, 10, 17.5F, 10, thick), line(17.5F, 10, 17.5F, 5, thick),
          line(17.5F, 5, 21.5F, 5, thick)};
}

Shapes shapes_of_place(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::Toilets:
      return both(man(6), woman(18), {line(12, 2.5F, 12, 21.5F, 1)});
    case PlaceKind::AccessibleToilets:
      return shapes_of_wheelchair();
    case PlaceKind::AllGenderToilets:
      return {box(4.5F, 2, 4, 11),      box(4.5F, 10, 15, 3.2F, 1.4F), disc(12.5F, 12.5F, 5.6F),
              cut(box(2, 1, 20, 8.6F)), box(4.5F, 2, 4, 11),           box(8.5F, 16, 7, 5.5F)};
    case PlaceKind::WomensToilets:
      return both(woman(12), {}, {});
    case PlaceKind::MensToilets:
      return both(man(12), {}, {});
    case PlaceKind::BabyChange:
      return {disc(12, 5, 3),
              box(8.2F, 9, 7.6F, 8.5F, 3),
              line(8.8F, 11, 4.6F, 8.6F, 2),
              line(15.2F, 11, 19.4F, 8.6F, 2),
              line(9.8F, 16, 7, 21, 2.4F),
              line(14.2F, 16, 17, 21, 2.4F),
              cut(line(8, 14.2F, 16, 14.2F, 1.1F))};
    case PlaceKind::Exit:
      return {box(3, 2, 11, 20),
              cut(box(5, 4, 7, 16)),
              cut(box(11, 9, 5, 6)),
              line(8, 12, 20.5F, 12, 2.1F),
              line(20.5F, 12, 16.5F, 8, 2.1F),
              line(20.5F, 12, 16.5F, 16, 2.1F)};
    case PlaceKind::EmergencyExit:
      return {box(17, 2, 5, 20),
              cut(box(18.4F, 3.5F, 2.2F, 17)),
              disc(11.2F, 4, 2.1F),
              line(10.2F, 8.4F, 8.4F, 13.4F, 2.7F),
              line(10.4F, 8, 15, 10.8F, 1.7F),
              line(9.6F, 8, 5, 9.8F, 1.7F),
              line(8.4F, 13.6F, 12, 16.6F, 2),
              line(12, 16.6F, 11.4F, 21, 2),
              line(8.2F, 13.6F, 6.4F, 18, 2),
              line(6.4F, 18, 2.6F, 18.4F, 2)};
    case PlaceKind::Entrance:
      return {box(10, 2, 11, 20),        cut(box(12, 4, 7, 16)),    cut(box(8, 9, 5, 6)),
              line(3, 12, 15, 12, 2.1F), line(15, 12, 11, 8, 2.1F), line(15, 12, 11, 16, 2.1F)};
    case PlaceKind::Information:
      return {disc(12, 5.2F, 2.2F), line(9.6F, 10.6F, 12, 10.6F, 2.2F),
              line(12, 10.8F, 12, 19.4F, 3), line(9, 19.8F, 15, 19.8F, 2.2F)};
    case PlaceKind::Tickets:
      return {box(2, 6.5F, 20, 11, 1.2F),
              cut(disc(2, 12, 2.2F)),
              cut(disc(22, 12, 2.2F)),
              cut(line(15.5F, 8.6F, 15.5F, 9.6F, 1)),
              cut(line(15.5F, 11.5F, 15.5F, 12.5F, 1)),
              cut(line(15.5F, 14.4F, 15.5F, 15.4F, 1))};
    case PlaceKind::Cloakroom:
      return {ring(12, 5.4F, 2.3F, 1.7F),      cut(box(8, 5.6F, 3.6F, 3)),
              line(12, 7.6F, 12, 9.6F, 1.7F),  line(12, 9.6F, 2.8F, 16.6F, 2),
              line(12, 9.6F, 21.2F, 16.6F, 2), line(2.8F, 17.4F, 21.2F, 17.4F, 2)};
    case PlaceKind::Lockers:
      return {box(3, 2, 18, 20), cut(box(5, 4, 6.2F, 16)), cut(box(12.8F, 4, 6.2F, 16)),
              disc(9.2F, 12, 1.2F), disc(14.8F, 12, 1.2F)};
    case PlaceKind::Cafe:
      return {ring(16, 12.4F, 3.4F, 1.8F), box(4, 8, 12, 10, 3), line(3, 21, 17, 21, 1.8F),
              line(8, 2.6F, 8, 5.2F, 1.5F), line(12, 2.6F, 12, 5.2F, 1.5F)};
    case PlaceKind::Restaurant:
      return {line(7, 8, 7, 21.5F, 2.2F),      line(4, 3, 4, 8, 1.5F),
              line(7, 3, 7, 8, 1.5F),          line(10, 3, 10, 8, 1.5F),
              line(4, 8.2F, 10, 8.2F, 1.8F),   line(16.6F, 12, 16.6F, 21.5F, 2.2F),
              box(15.6F, 2.2F, 4.4F, 11.5F, 2)};
    case PlaceKind::Shop:
      return {ring(12, 8, 4, 1.8F), box(4, 8.6F, 16, 13, 1.4F)};
    case PlaceKind::Lift:
      return {box(3.5F, 2, 17, 20), cut(box(5.4F, 3.9F, 13.2F, 16.2F)),
              triangle({12, 6}, {8.6F, 10.4F}, {15.4F, 10.4F}),
              triangle({12, 18}, {8.6F, 13.6F}, {15.4F, 13.6F})};
    case PlaceKind::Stairs:
      return shapes_of_stairs(2.3F);
    case PlaceKind::Seat:
      return {line(4, 7, 20, 7, 2.4F), line(3, 13, 21, 13, 2.6F), line(5.6F, 7, 5.6F, 20, 2),
              line(18.4F, 7, 18.4F, 20, 2)};
    case PlaceKind::Water:
      return {disc(12, 15, 6), triangle({12, 3}, {6.8F, 12.6F}, {17.2F, 12.6F})};
    case PlaceKind::FirstAid:
      return {box(9, 3, 6, 18), box(3, 9, 18, 6)};
    case PlaceKind::Defibrillator:
      return {disc(7.6F, 8.4F, 4.7F),
              disc(16.4F, 8.4F, 4.7F),
              triangle({3.8F, 11.4F}, {20.2F, 11.4F}, {12, 21}),
              disc(12, 11, 3.2F),
              cut(line(13.4F, 6, 10, 11.6F, 1.5F)),
              cut(line(10, 11.6F, 14, 11.6F, 1.5F)),
              cut(line(14, 11.6F, 11, 17, 1.5F))};
    case PlaceKind::QuietRoom:
      return {disc(11, 12, 9), cut(disc(15.6F, 9, 7.6F))};
    case PlaceKind::PrayerRoom:
      return {disc(10, 4.6F, 2.2F), line(9.6F, 9, 8, 15, 3), line(9.8F, 9.2F, 15.4F, 8, 1.8F),
              line(8, 15.6F, 15, 18.4F, 2.4F), line(15, 19.8F, 5, 20.4F, 2.2F)};
    case PlaceKind::MeetingPoint:
      return {disc(12, 12, 2.8F),
              line(3.2F, 3.2F, 7.6F, 7.6F, 1.9F),
              line(7.6F, 7.6F, 7.6F, 3.6F, 1.9F),
              line(7.6F, 7.6F, 3.6F, 7.6F, 1.9F),
              line(20.8F, 3.2F, 16.4F, 7.6F, 1.9F),
              line(16.4F, 7.6F, 16.4F, 3.6F, 1.9F),
              line(16.4F, 7.6F, 20.4F, 7.6F, 1.9F),
              line(3.2F, 20.8F, 7.6F, 16.4F, 1.9F),
              line(7.6F, 16.4F, 7.6F, 20.4F, 1.9F),
              line(7.6F, 16.4F, 3.6F, 16.4F, 1.9F),
              line(20.8F, 20.8F, 16.4F, 16.4F, 1.9F),
              line(16.4F, 16.4F, 16.4F, 20.4F, 1.9F),
              line(16.4F, 16.4F, 20.4F, 16.4F, 1.9F)};
    case PlaceKind::LostAndFound:
      return {disc(12, 11.4F, 9.2F),
              cut(box(0, 11.4F, 24, 14)),
              cut(disc(6, 12.6F, 2.4F)),
              cut(disc(12, 12.6F, 2.4F)),
              cut(disc(18, 12.6F, 2.4F)),
              line(12, 10, 12, 19.6F, 1.8F),
              line(12, 20.4F, 15, 20.4F, 1.8F),
              line(15.4F, 18.4F, 15.4F, 20, 1.8F)};
    case PlaceKind::CashMachine:
      return {box(2, 6, 20, 12), cut(box(4, 8, 16, 8)), disc(12, 12, 3)};
    case PlaceKind::Telephone:
      return {line(4.5F, 6.6F, 19.5F, 6.6F, 3.4F), box(2.6F, 5, 5.4F, 6, 1.6F),
              box(16, 5, 5.4F, 6, 1.6F), box(5, 11.5F, 14, 9.5F, 2), cut(disc(12, 16.2F, 2.8F))};
    case PlaceKind::Library:
      return {box(2.5F, 4.5F, 8.7F, 14.5F),          box(12.8F, 4.5F, 8.7F, 14.5F),
              line(3.4F, 20.6F, 20.6F, 20.6F, 1.6F), cut(line(5, 8.6F, 8.8F, 8.6F, 1.2F)),
              cut(line(5, 12, 8.8F, 12, 1.2F)),      cut(line(15.2F, 8.6F, 19, 8.6F, 1.2F)),
              cut(line(15.2F, 12, 19, 12, 1.2F))};
    case PlaceKind::Auditorium:
      return {box(3, 2.5F, 18, 9.5F),
              cut(box(5, 4.5F, 14, 5.5F)),
              disc(6, 16, 2),
              disc(12, 16, 2),
              disc(18, 16, 2),
              box(3.4F, 18.8F, 5.2F, 3.4F, 1.4F),
              box(9.4F, 18.8F, 5.2F, 3.4F, 1.4F),
              box(15.4F, 18.8F, 5.2F, 3.4F, 1.4F)};
    case PlaceKind::Parking:
      return {ring(12.4F, 8.4F, 4.2F, 3), cut(box(5, 2, 5.8F, 14)),
              line(8.6F, 4.2F, 8.6F, 20, 3.2F), line(8.6F, 4.2F, 12, 4.2F, 3),
              line(8.6F, 12.6F, 12, 12.6F, 3)};
    case PlaceKind::Count:
      break;
  }
  return {};
}

Shapes shapes_of(Pictogram what) {
  switch (what) {
    case Pictogram::Exhibits:
      return {box(2.5F, 3.5F, 19, 17), cut(box(4.6F, 5.6F, 14.8F, 12.8F)), disc(8.4F, 9, 1.5F),
              triangle({6, 17}, {13, 9.4F}, {18, 17})};
    case Pictogram::Places:
      return {disc(12, 9.2F, 6.6F), triangle({6.8F, 12.6F}, {17.2F, 12.6F}, {12, 21.6F}),
              cut(disc(12, 9.2F, 2.7F))};
    case Pictogram::StepFree:
      return shapes_of_wheelchair();
    case Pictogram::NoEscalators: {
      Shapes shapes = shapes_of_stairs(2.3F);
      for (const Shape& shape :
           {cut(line(3.5F, 3.5F, 20.5F, 20.5F, 4.6F)), line(3.5F, 3.5F, 20.5F, 20.5F, 2)})
        shapes.push_back(shape);
      return shapes;
    }
    case Pictogram::Languages:  // a globe
      return {ring(12, 12, 9, 1.7F),
              line(3, 12, 21, 12, 1.5F),
              line(12, 3, 8.7F, 7.4F, 1.5F),
              line(8.7F, 7.4F, 7.7F, 12, 1.5F),
              line(7.7F, 12, 8.7F, 16.6F, 1.5F),
              line(8.7F, 16.6F, 12, 21, 1.5F),
              line(12, 3, 15.3F, 7.4F, 1.5F),
              line(15.3F, 7.4F, 16.3F, 12, 1.5F),
              line(16.3F, 12, 15.3F, 16.6F, 1.5F),
              line(15.3F, 16.6F, 12, 21, 1.5F)};
    case Pictogram::Speak:  // a loudspeaker, and two waves
      return {box(2.5F, 8.6F, 5, 6.8F),        triangle({4.5F, 12}, {12, 4.4F}, {12, 19.6F}),
              line(15.2F, 9, 16.4F, 12, 1.9F), line(16.4F, 12, 15.2F, 15, 1.9F),
              line(18.4F, 6, 20.8F, 12, 1.9F), line(20.8F, 12, 18.4F, 18, 1.9F)};
    case Pictogram::LargerLetters:  // a large A beside a small one
      return {line(2.6F, 20, 8.4F, 4, 2.4F),       line(8.4F, 4, 14.2F, 20, 2.4F),
              line(4.8F, 14.6F, 12, 14.6F, 2.2F),  line(15, 20, 18.4F, 10.6F, 1.9F),
              line(18.4F, 10.6F, 21.8F, 20, 1.9F), line(16.2F, 16.8F, 20.6F, 16.8F, 1.7F)};
    case Pictogram::Contrast:  // a disc, half of it full
      return {disc(12, 12, 6), cut(box(2, 2, 10, 20, 0.1F)), ring(12, 12, 8.4F, 2.2F)};
    case Pictogram::Lower:  // down to a line
      return {line(12, 3, 12, 12, 2.6F), triangle({5.6F, 10.6F}, {18.4F, 10.6F}, {12, 18}),
              line(4, 20.8F, 20, 20.8F, 2.4F)};
    case Pictogram::Time:  // a clock at four
      return {disc(12, 12, 10), cut(disc(12, 12, 8)), line(12, 6, 12, 12.4F, 1.9F),
              line(12, 12.4F, 16, 14.8F, 1.9F)};
    case Pictogram::Search:  // a magnifying glass
      return {ring(10, 10, 6.2F, 2.2F), line(14.8F, 14.8F, 20.4F, 20.4F, 2.8F)};
    case Pictogram::FurtherUp:
      return {line(5, 15.5F, 12, 8.5F, 2.6F), line(12, 8.5F, 19, 15.5F, 2.6F)};
    case Pictogram::FurtherDown:
      return {line(5, 8.5F, 12, 15.5F, 2.6F), line(12, 15.5F, 19, 8.5F, 2.6F)};
    case Pictogram::LeafLeft:
      return {line(15.5F, 5, 8.5F, 12, 2.6F), line(8.5F, 12, 15.5F, 19, 2.6F)};
    case Pictogram::LeafRight:
      return {line(8.5F, 5, 15.5F, 12, 2.6F), line(15.5F, 12, 8.5F, 19, 2.6F)};
    case Pictogram::Count:
      return {};
  }
  return shapes_of_place(static_cast<PlaceKind>(what));
}

}  // namespace

TextBitmap draw_pictogram(Pictogram what, std::uint32_t side) {
  side = std::max(side, 1U);
  const Shapes shapes = shapes_of(what);
  const float pixels = static_cast<float>(side) / grid;
  TextBitmap bitmap{.width = side, .height = side, .lines = 1, .coverage = {}};
  bitmap.coverage.reserve(std::size_t{side} * side);
  for (std::uint32_t row = 0; row < side; ++row)
    for (std::uint32_t column = 0; column < side; ++column) {
      const Point at{(static_cast<float>(column) + 0.5F) / pixels,
                     (static_cast<float>(row) + 0.5F) / pixels};
      float off = grid;
      for (const Shape& shape : shapes)
        off = shape.cuts ? std::max(off, -distance(at, shape)) : std::min(off, distance(at, shape));
      const float covered = std::clamp(0.5F - off * pixels, 0.0F, 1.0F);
      bitmap.coverage.push_back(static_cast<std::uint8_t>(std::lround(255 * covered)));
    }
  return bitmap;
}

}  // namespace docent::interface
