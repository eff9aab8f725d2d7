#pragma once

#include <vector>

#include "content/import/building/imported_building.h"
#include "content/import/xml/xml_tree.h"

namespace docent::import {

/// A point of a GML geometry: the plane's two numbers and the height, as written.
struct GmlPoint {
  Vec2 at{};
  double height = 0;
};

/// All positions under an element (`pos`, `posList`, `coordinates`), in order. What is no number is
/// an error with its place.
std::vector<GmlPoint> gml_points(const std::string& file, const XmlElement& element);

/// A polygon's rings, the outer one first, none closed by a repeated point.
std::vector<std::vector<GmlPoint>> gml_rings(const std::string& file, const XmlElement& polygon);

/// The horizontal polygons under an element that lie lowest (within 0.3), united to one area: the
/// floor of a solid, or the polygon itself of a plan. `height` is theirs.
struct GmlFloor {
  std::vector<std::vector<BuildingRing>> polygons{};
  double height = 0;
};
GmlFloor gml_floor(const std::string& file, const XmlElement& element);

}  // namespace docent::import
