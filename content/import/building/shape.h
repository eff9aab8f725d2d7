#pragma once

#include <memory>
#include <span>
#include <vector>

#include "content/import/building/imported_building.h"

struct GEOSGeom_t;

namespace docent::import {

/// The smallest box about something, sides along the axes.
struct Box {
  Vec2 low{}, high{};
};

/// Part of a level's plane: none, one or several polygons with holes. What is computed with it is
/// good to a micrometre (GEOS, in doubles); the walls themselves are computed exactly, later, from
/// what is written (content/floor/mend.h).
class Shape {
 public:
  Shape();
  explicit Shape(GEOSGeom_t* owned);
  ~Shape();
  Shape(Shape&& other) noexcept;
  Shape& operator=(Shape&& other) noexcept;
  Shape(const Shape& other);
  Shape& operator=(const Shape& other);

  [[nodiscard]] const GEOSGeom_t* get() const noexcept { return geometry_; }
  [[nodiscard]] bool empty() const;
  [[nodiscard]] double area() const;
  [[nodiscard]] Box bounds() const;  ///< Of an empty one: a point at the origin.

 private:
  GEOSGeom_t* geometry_;
};

/// The inside of the first ring without that of the others. Rings may cross themselves.
Shape shape_of(std::span<const BuildingRing> rings);
/// Do sides of the ring cross or touch that are no neighbours?
bool crosses_itself(const BuildingRing& ring);
/// What is nearer to the line than that; its ends are cut square, `overhang` beyond the line.
enum class LineEnds { Flat, Square };
Shape shape_about(std::span<const Vec2> line, double half_width, LineEnds ends);

Shape united(std::span<const Shape> shapes);
Shape common(const Shape& a, const Shape& b);
Shape without(const Shape& a, const Shape& b);
/// Grown by that many metres all round, with corners kept sharp; shrunk where it is negative.
Shape grown(const Shape& shape, double by);
/// On a grid of that many metres, without vertices that say nothing.
Shape on_grid(const Shape& shape, double grid);

double distance(const Shape& shape, Vec2 point);
double distance(const Shape& a, const Shape& b);
bool holds(const Shape& shape, Vec2 point);
/// The point farthest from the shape's edge, to within `tolerance` metres.
Vec2 middle_of(const Shape& shape, double tolerance = 0.05);

/// Its polygons, each with its outer ring (counter-clockwise) first, the largest polygon first.
std::vector<std::vector<BuildingRing>> polygons_of(const Shape& shape);

bool meet(const Box& a, const Box& b, double margin) noexcept;

}  // namespace docent::import
