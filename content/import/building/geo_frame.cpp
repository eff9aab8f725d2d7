#include "content/import/building/geo_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "content/content_error.h"
#include "content/import/building/shape.h"
#include "content/import/drawing/unit.h"
#include "content/import/floor/projection.h"
#include "runtime/model/none.h"

namespace docent::import {
namespace {

constexpr double earth_radius = 6378137;  // Metres, as EPSG:3857 has it.
constexpr double degree = std::numbers::pi / 180;

Vec2 mercator_to_degrees(Vec2 metres) {
  return {metres.x / earth_radius / degree,
          (2 * std::atan(std::exp(metres.y / earth_radius)) - std::numbers::pi / 2) / degree};
}

Box box_of(const MapNumbersSeen& seen) {
  Box box{{infinity, infinity}, {-infinity, -infinity}};
  for (const std::vector<Vec2>& ring : seen.rings)
    for (const Vec2 point : ring) {
      box.low = glm::min(box.low, point);
      box.high = glm::max(box.high, point);
    }
  return box;
}

/// How much of the rings' corners is square, each weighed by its shorter side: buildings are, and
/// a wrong frame skews them.
double squareness(const MapNumbersSeen& seen, const GeoFrame& frame) {
  double square = 0, all = 0;
  for (const std::vector<Vec2>& ring : seen.rings)
    for (std::size_t i = 0; i + 2 < ring.size(); ++i) {
      const Vec2 a = frame.to_floor(ring[i]), b = frame.to_floor(ring[i + 1]),
                 c = frame.to_floor(ring[i + 2]);
      const double ab = glm::distance(a, b), bc = glm::distance(b, c);
      if (ab < 0.2 || bc < 0.2) continue;
      const double turn = std::abs(std::atan2(cross(b - a, c - b), dot(b - a, c - b)));
      if (turn < 5 * degree) continue;
      all += std::min(ab, bc);
      if (std::abs(turn - std::numbers::pi / 2) < 2.5 * degree) square += std::min(ab, bc);
    }
  return all > 0 ? square / all : 0;
}

/// No building is larger. Degrees and metres.
constexpr double largest_degrees = 0.3;
constexpr double largest_metres = 20'000;

[[noreturn]] void fail(const MapNumbersSeen& seen, const std::string& message, std::string hint) {
  throw content::ContentError(seen.file, 0, 0, "unknown-frame", message, std::move(hint));
}

/// One origin for a museum: the command line's or the museum's own, else the middle of what is
/// drawn, to a hundred thousandth of a degree, so that it can be written.
Vec2 origin_for(Vec2 middle, const ImportOptions& options) {
  if (options.origin) return *options.origin;
  return {std::round(middle.x * 1e5) / 1e5, std::round(middle.y * 1e5) / 1e5};
}

void check_near_origin(const MapNumbersSeen& seen, Vec2 middle, const ImportOptions& options) {
  if (!options.origin) return;
  const double away = glm::length(LocalProjection(*options.origin).to_floor(middle));
  if (std::isfinite(away) && away < 50'000 && std::abs(middle.y - options.origin->y) < 1) return;
  fail(seen,
       fmt::format("the plan lies at {:.5f}, {:.5f} (latitude, longitude), far from the museum's "
                   "origin {:.5f}, {:.5f}",
                   middle.y, middle.x, options.origin->y, options.origin->x),
       "give --origin LAT,LON for this building, or import it into a museum of its own");
}

GeoFrame degrees_frame(const MapNumbersSeen& seen, const Box& box, const ImportOptions& options) {
  const Vec2 middle = (box.low + box.high) / 2.0;
  const Vec2 turned{middle.y, middle.x};
  GeoFrame straight{.numbers = MapNumbers::Degrees,
                    .origin = origin_for(middle, options),
                    .said = "longitude and latitude"};
  GeoFrame swapped{.numbers = MapNumbers::SwappedDegrees,
                   .origin = origin_for(turned, options),
                   .sure = false,
                   .said = "latitude and longitude: swapped"};
  if (std::abs(middle.y) > 90) return swapped;
  if (std::abs(middle.x) > 90 || seen.always_degrees) {
    check_near_origin(seen, middle, options);
    return straight;
  }
  if (options.origin) {
    const bool nearer =
        glm::distance(turned, *options.origin) + 1 < glm::distance(middle, *options.origin);
    if (!nearer) check_near_origin(seen, middle, options);
    return nearer ? swapped : straight;
  }
  constexpr double clearly = 0.25;
  return squareness(seen, swapped) > squareness(seen, straight) + clearly ? swapped : straight;
}

GeoFrame mercator_frame(const Box& box, const ImportOptions& options, bool sure) {
  return {.numbers = MapNumbers::WebMercator,
          .origin = origin_for(mercator_to_degrees((box.low + box.high) / 2.0), options),
          .sure = sure,
          .said = sure ? "Web Mercator, as the file says" : "Web Mercator, as the numbers look"};
}

GeoFrame lengths_frame(const Box& box, double unit, std::string said, bool sure) {
  GeoFrame frame{.unit = unit, .sure = sure, .said = std::move(said)};
  // Large numbers are those of a country's grid: the building gets its own corner.
  if (std::max(glm::length(box.low), glm::length(box.high)) * unit > largest_metres)
    frame.origin = glm::floor(box.low);
  return frame;
}

bool says(std::string_view crs, std::string_view what) {
  return crs.find(what) != std::string_view::npos;
}

}  // namespace

Vec2 GeoFrame::to_floor(Vec2 written) const {
  switch (numbers) {
    case MapNumbers::Degrees:
      return LocalProjection(origin).to_floor(written);
    case MapNumbers::SwappedDegrees:
      return LocalProjection(origin).to_floor({written.y, written.x});
    case MapNumbers::WebMercator:
      return LocalProjection(origin).to_floor(mercator_to_degrees(written));
    case MapNumbers::Lengths:
      break;
  }
  return (written - origin) * unit;
}

double unit_in_metres(std::string_view unit) {
  return metres_of(unit).value_or(0);
}

GeoFrame find_frame(const MapNumbersSeen& seen, const ImportOptions& options) {
  const Box box = box_of(seen);
  if (!(box.low.x <= box.high.x)) return {.said = "nothing is drawn"};
  const Vec2 size = box.high - box.low;
  const double largest = std::max(size.x, size.y);
  if (const double unit = unit_in_metres(options.unit); unit > 0)
    return lengths_frame(box, unit, "lengths, as --unit says", true);
  if (says(seen.crs, "3857") || says(seen.crs, "900913") || says(seen.crs, "3785"))
    return mercator_frame(box, options, true);
  const double farthest = std::max(
      {std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  const bool can_be_degrees = farthest <= 180;
  if (can_be_degrees && largest < largest_degrees) return degrees_frame(seen, box, options);
  if (seen.always_degrees || says(seen.crs, "CRS84") || says(seen.crs, "4326"))
    fail(
        seen,
        fmt::format("what this file calls longitude and latitude spans {:.4g} by {:.4g} degrees, "
                    "some {:.0f} km: these are the numbers of a drawing",
                    size.x, size.y, largest * 111),
        "say how long one of them is with --unit m, cm, mm, ft or in, or export it again in WGS84");
  if (!seen.crs.empty() && largest <= largest_metres)
    return lengths_frame(box, 1, fmt::format("metres of {}", seen.crs), true);
  if (farthest > 100'000) {
    if (largest > 2 * largest_metres)
      fail(seen,
           fmt::format("the plan is {:.3g} by {:.3g} of whatever its numbers are", size.x, size.y),
           "say with --unit what they are, or export it in WGS84");
    if (farthest < 20'037'509) return mercator_frame(box, options, false);
  }
  if (largest > largest_metres)
    fail(seen,
         fmt::format("the plan is {:.3g} by {:.3g} of whatever its numbers are", size.x, size.y),
         "say with --unit m, cm, mm, ft or in how long one is");
  return lengths_frame(box, 1, "metres", true);
}

}  // namespace docent::import
