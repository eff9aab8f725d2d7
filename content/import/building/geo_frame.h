#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "content/import/building/imported_building.h"

namespace docent::import {

/// What the numbers of a map turn out to be.
enum class MapNumbers {
  Degrees,         ///< Longitude, then latitude.
  SwappedDegrees,  ///< Latitude, then longitude.
  WebMercator,     ///< EPSG:3857: too long by the latitude's secant.
  Lengths,         ///< A unit of length, on a plane.
};

/// Lays a map's numbers out in the building's frame.
struct GeoFrame {
  MapNumbers numbers = MapNumbers::Lengths;
  Vec2 origin{};  ///< Of degrees: longitude and latitude of (0, 0). Of lengths: what is taken off.
  double unit = 1;     ///< Metres; of lengths.
  bool sure = true;    ///< Stated, or the numbers can mean nothing else.
  std::string said{};  ///< How it was found, as a sentence.

  [[nodiscard]] Vec2 to_floor(Vec2 written) const;
};

/// A map's numbers before anybody knows what they mean.
struct MapNumbersSeen {
  std::string file{};
  std::string crs{};            ///< As the file says: `EPSG:3857`, `urn:ogc:def:crs:OGC:1.3:CRS84`.
  bool always_degrees = false;  ///< The format knows nothing else (OpenStreetMap, IMDF).
  std::vector<std::vector<Vec2>> rings{};  ///< Those of rooms: their corners tell the frame.
};

/// Finds out what the numbers mean. Throws ContentError with one sentence where they mean nothing
/// that a building could be.
GeoFrame find_frame(const MapNumbersSeen& seen, const ImportOptions& options);

/// Metres in a unit of the command line, as metres_of() knows them; 0 for one that there is not.
double unit_in_metres(std::string_view unit);

}  // namespace docent::import
