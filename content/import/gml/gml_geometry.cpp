#include "content/import/gml/gml_geometry.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "content/content_error.h"
#include "content/import/building/shape.h"

namespace docent::import {
namespace {

std::vector<double> numbers_of(const std::string& file, const XmlElement& element) {
  std::vector<double> numbers;
  const char* at = element.text.data();
  const char* const end = at + element.text.size();
  while (at != end) {
    if (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r' || *at == ',') {
      ++at;
      continue;
    }
    double value = 0;
    const auto [next, fault] = std::from_chars(at, end, value);
    if (fault != std::errc{} || !std::isfinite(value) || std::abs(value) > 1e9)
      throw content::ContentError(file, element.line, element.column, "invalid-gml",
                                  "a position holds something that is no number",
                                  "export the model again");
    numbers.push_back(value);
    at = next;
  }
  return numbers;
}

std::size_t dimension_of(const XmlElement& element, std::size_t count) {
  const std::string_view said = element.attribute("srsDimension");
  if (said == "2") return 2;
  if (said == "3") return 3;
  if (element.name == "pos") return count == 2 ? 2 : 3;
  return count % 3 == 0 ? 3 : 2;
}

void collect_points(const std::string& file, const XmlElement& element,
                    std::vector<GmlPoint>& points) {
  if (element.name == "pos" || element.name == "posList" || element.name == "coordinates") {
    const std::vector<double> numbers = numbers_of(file, element);
    const std::size_t dimension = dimension_of(element, numbers.size());
    for (std::size_t i = 0; i + dimension <= numbers.size(); i += dimension)
      points.push_back({{numbers[i], numbers[i + 1]}, dimension == 3 ? numbers[i + 2] : 0});
    return;
  }
  for (const XmlElement& child : element.children) collect_points(file, child, points);
}

}  // namespace

std::vector<GmlPoint> gml_points(const std::string& file, const XmlElement& element) {
  std::vector<GmlPoint> points;
  collect_points(file, element, points);
  return points;
}

std::vector<std::vector<GmlPoint>> gml_rings(const std::string& file, const XmlElement& polygon) {
  std::vector<std::vector<GmlPoint>> rings;
  for (const XmlElement& side : polygon.children) {
    if (side.name != "exterior" && side.name != "interior" && side.name != "outerBoundaryIs" &&
        side.name != "innerBoundaryIs")
      continue;
    std::vector<GmlPoint> ring = gml_points(file, side);
    if (ring.size() > 1 && ring.front().at == ring.back().at &&
        ring.front().height == ring.back().height)
      ring.pop_back();
    if (ring.size() >= 3)
      rings.push_back(std::move(ring));
    else if (rings.empty())
      break;
  }
  return rings;
}

GmlFloor gml_floor(const std::string& file, const XmlElement& element) {
  struct Flat {
    std::vector<BuildingRing> rings;
    double height = 0;
  };
  std::vector<Flat> flats;
  for (const XmlElement* polygon : find_all(element, "Polygon")) {
    const auto rings = gml_rings(file, *polygon);
    if (rings.empty()) continue;
    const auto [low, high] = std::ranges::minmax(rings[0], {}, &GmlPoint::height);
    if (high.height - low.height > 0.1) continue;
    Flat flat{.rings = {}, .height = low.height};
    for (const auto& ring : rings) {
      BuildingRing drawn;
      for (const GmlPoint& point : ring)
        if (drawn.empty() || drawn.back() != point.at) drawn.push_back(point.at);
      flat.rings.push_back(std::move(drawn));
    }
    flats.push_back(std::move(flat));
  }
  GmlFloor floor;
  if (flats.empty()) return floor;
  floor.height = std::ranges::min(flats, {}, &Flat::height).height;
  std::vector<Shape> shapes;
  for (const Flat& flat : flats)
    if (flat.height < floor.height + 0.3) shapes.push_back(shape_of(flat.rings));
  floor.polygons = polygons_of(united(shapes));
  return floor;
}

}  // namespace docent::import
