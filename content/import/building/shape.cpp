#include "content/import/building/shape.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace docent::import {
namespace {

/// GEOS works in a context; faults come back as null, which is taken for an empty shape.
GEOSContextHandle_t context() {
  struct Finish {
    void operator()(GEOSContextHandle_t handle) const noexcept { GEOS_finish_r(handle); }
  };
  using Handle = std::unique_ptr<std::remove_pointer_t<GEOSContextHandle_t>, Finish>;
  thread_local const Handle handle(GEOS_init_r());
  return handle.get();
}

GEOSGeom_t* nothing() {
  return GEOSGeom_createEmptyPolygon_r(context());
}

GEOSCoordSequence* sequence(std::span<const Vec2> points, bool close) {
  const auto count = static_cast<unsigned>(points.size() + (close ? 1 : 0));
  GEOSCoordSequence* made = GEOSCoordSeq_create_r(context(), count, 2);
  for (unsigned i = 0; i < count; ++i) {
    const Vec2 point = points[i % points.size()];
    GEOSCoordSeq_setXY_r(context(), made, i, point.x, point.y);
  }
  return made;
}

Shape taken(GEOSGeometry* geometry) {
  return Shape(geometry == nullptr ? nothing() : geometry);
}

/// One ring's inside as it is drawn.
Shape drawn_shape(const BuildingRing& ring) {
  if (ring.size() < 3) return {};
  GEOSGeometry* line = GEOSGeom_createLinearRing_r(context(), sequence(ring, true));
  if (line == nullptr) return {};
  return taken(GEOSGeom_createPolygon_r(context(), line, nullptr, 0));
}

/// One ring's inside, whatever way it crosses itself.
Shape ring_shape(const BuildingRing& ring) {
  Shape drawn = drawn_shape(ring);
  if (GEOSisValid_r(context(), drawn.get()) == 1) return drawn;
  return taken(GEOSBuffer_r(context(), taken(GEOSMakeValid_r(context(), drawn.get())).get(), 0, 8));
}

BuildingRing ring_of(const GEOSGeometry* line) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(context(), line);
  unsigned count = 0;
  GEOSCoordSeq_getSize_r(context(), points, &count);
  BuildingRing ring;
  for (unsigned i = 0; i + 1 < count; ++i) {
    Vec2 point{};
    GEOSCoordSeq_getXY_r(context(), points, i, &point.x, &point.y);
    ring.push_back(point);
  }
  return ring;
}

double signed_area(const BuildingRing& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return area / 2;
}

void collect(const GEOSGeometry* geometry, std::vector<std::vector<BuildingRing>>& polygons) {
  if (GEOSGeomTypeId_r(context(), geometry) == GEOS_POLYGON) {
    if (GEOSisEmpty_r(context(), geometry) == 1) return;
    std::vector<BuildingRing> rings{ring_of(GEOSGetExteriorRing_r(context(), geometry))};
    if (signed_area(rings[0]) < 0) std::ranges::reverse(rings[0]);
    for (int i = 0; i < GEOSGetNumInteriorRings_r(context(), geometry); ++i) {
      rings.push_back(ring_of(GEOSGetInteriorRingN_r(context(), geometry, i)));
      if (signed_area(rings.back()) > 0) std::ranges::reverse(rings.back());
    }
    polygons.push_back(std::move(rings));
    return;
  }
  if (GEOSGeomTypeId_r(context(), geometry) < GEOS_MULTIPOINT) return;
  for (int i = 0; i < GEOSGetNumGeometries_r(context(), geometry); ++i)
    collect(GEOSGetGeometryN_r(context(), geometry, i), polygons);
}

struct Point {
  explicit Point(Vec2 at) : geometry(GEOSGeom_createPointFromXY_r(context(), at.x, at.y)) {}
  ~Point() { GEOSGeom_destroy_r(context(), geometry); }
  Point(const Point&) = delete;
  Point& operator=(const Point&) = delete;
  GEOSGeometry* geometry;
};

}  // namespace

Shape::Shape() : geometry_(nothing()) {}
Shape::Shape(GEOSGeom_t* owned) : geometry_(owned) {}
Shape::~Shape() {
  if (geometry_ != nullptr) GEOSGeom_destroy_r(context(), geometry_);
}
Shape::Shape(Shape&& other) noexcept : geometry_(std::exchange(other.geometry_, nullptr)) {}
Shape& Shape::operator=(Shape&& other) noexcept {
  std::swap(geometry_, other.geometry_);
  return *this;
}
Shape::Shape(const Shape& other)
    : geometry_(other.geometry_ == nullptr ? nothing()
                                           : GEOSGeom_clone_r(context(), other.geometry_)) {}
Shape& Shape::operator=(const Shape& other) {
  Shape copy(other);
  std::swap(geometry_, copy.geometry_);
  return *this;
}

bool Shape::empty() const {
  return geometry_ == nullptr || GEOSisEmpty_r(context(), geometry_) != 0;
}
double Shape::area() const {
  double area = 0;
  GEOSArea_r(context(), geometry_, &area);
  return area;
}
Box Shape::bounds() const {
  Box box;
  if (empty()) return box;
  GEOSGeom_getXMin_r(context(), geometry_, &box.low.x);
  GEOSGeom_getYMin_r(context(), geometry_, &box.low.y);
  GEOSGeom_getXMax_r(context(), geometry_, &box.high.x);
  GEOSGeom_getYMax_r(context(), geometry_, &box.high.y);
  return box;
}

bool crosses_itself(const BuildingRing& ring) {
  return GEOSisValid_r(context(), drawn_shape(ring).get()) != 1;
}

Shape shape_of(std::span<const BuildingRing> rings) {
  if (rings.empty()) return {};
  Shape shape = ring_shape(rings[0]);
  for (const BuildingRing& hole : rings.subspan(1)) shape = without(shape, ring_shape(hole));
  return shape;
}

Shape shape_about(std::span<const Vec2> line, double half_width, LineEnds ends) {
  if (line.size() < 2) return {};
  const Shape drawn = taken(GEOSGeom_createLineString_r(context(), sequence(line, false)));
  return taken(GEOSBufferWithStyle_r(context(), drawn.get(), half_width, 4,
                                     ends == LineEnds::Flat ? GEOSBUF_CAP_FLAT : GEOSBUF_CAP_SQUARE,
                                     GEOSBUF_JOIN_MITRE, 2));
}

Shape united(std::span<const Shape> shapes) {
  std::vector<GEOSGeometry*> copies;
  for (const Shape& shape : shapes)
    if (!shape.empty()) copies.push_back(GEOSGeom_clone_r(context(), shape.get()));
  if (copies.empty()) return {};
  const Shape all = taken(GEOSGeom_createCollection_r(
      context(), GEOS_GEOMETRYCOLLECTION, copies.data(), static_cast<unsigned>(copies.size())));
  return taken(GEOSUnaryUnion_r(context(), all.get()));
}

Shape common(const Shape& a, const Shape& b) {
  return taken(GEOSIntersection_r(context(), a.get(), b.get()));
}
Shape without(const Shape& a, const Shape& b) {
  return taken(GEOSDifference_r(context(), a.get(), b.get()));
}
Shape grown(const Shape& shape, double by) {
  return taken(GEOSBufferWithStyle_r(context(), shape.get(), by, 8, GEOSBUF_CAP_FLAT,
                                     GEOSBUF_JOIN_MITRE, 3));
}
Shape on_grid(const Shape& shape, double grid) {
  const Shape simple = taken(GEOSTopologyPreserveSimplify_r(context(), shape.get(), grid));
  return taken(GEOSGeom_setPrecision_r(context(), simple.get(), grid, 0));
}

double distance(const Shape& shape, Vec2 point) {
  if (shape.empty()) return INFINITY;
  double found = INFINITY;
  GEOSDistance_r(context(), shape.get(), Point(point).geometry, &found);
  return found;
}
double distance(const Shape& a, const Shape& b) {
  if (a.empty() || b.empty()) return INFINITY;
  double found = INFINITY;
  GEOSDistance_r(context(), a.get(), b.get(), &found);
  return found;
}
bool holds(const Shape& shape, Vec2 point) {
  return GEOSIntersects_r(context(), shape.get(), Point(point).geometry) == 1;
}

Vec2 middle_of(const Shape& shape, double tolerance) {
  Vec2 middle{};
  if (shape.empty()) return middle;
  const auto polygons = polygons_of(shape);
  const Shape largest = polygons.empty() ? shape : shape_of(polygons.front());
  GEOSGeometry* radius = GEOSMaximumInscribedCircle_r(context(), largest.get(), tolerance);
  if (radius == nullptr) return polygons.empty() ? middle : polygons.front().front().front();
  const Shape line = taken(radius);
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(context(), line.get());
  GEOSCoordSeq_getXY_r(context(), points, 0, &middle.x, &middle.y);
  return middle;
}

std::vector<std::vector<BuildingRing>> polygons_of(const Shape& shape) {
  std::vector<std::vector<BuildingRing>> polygons;
  if (!shape.empty()) collect(shape.get(), polygons);
  std::ranges::stable_sort(polygons, [](const auto& a, const auto& b) {
    return signed_area(a.front()) > signed_area(b.front());
  });
  return polygons;
}

bool meet(const Box& a, const Box& b, double margin) noexcept {
  return a.low.x <= b.high.x + margin && b.low.x <= a.high.x + margin &&
         a.low.y <= b.high.y + margin && b.low.y <= a.high.y + margin;
}

}  // namespace docent::import
