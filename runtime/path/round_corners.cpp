#include "runtime/path/round_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "runtime/model/geometry/polyline.h"
#include "runtime/path/flatten.h"

namespace docent::path {
namespace {

/// Flattened curves turn by less than this at their points. Radians.
constexpr double least_turn = std::numbers::pi / 9;
/// How far from a corner its curve may begin. Metres.
constexpr double longest_leg = 1;
constexpr double shortest_leg = 1e-3;
/// Corners nearer to each other than this are one. Metres.
constexpr double same_corner = 0.2;

/// A corner of a way, or several so near to each other that they are rounded as one.
struct Corner {
  std::size_t tip = 0;         ///< Its point, the middle one of several.
  double first = 0, last = 0;  ///< Metres along the way of the first and the last.
  double leg = 0;              ///< Metres of way on either side of the tip to be replaced.
};

/// Points of a way with the metres of way before each.
class Polyline {
 public:
  explicit Polyline(const std::vector<Vec2>& points)
      : point_(points), before_(distances_along(points)) {}
  double length() const { return before_.back(); }
  double before(std::size_t i) const { return before_[i]; }

  /// The first point beyond a place, or the last one.
  std::size_t point_after(double at) const {
    const auto after = std::ranges::upper_bound(before_, at) - before_.begin();
    return std::clamp(static_cast<std::size_t>(after), std::size_t{1}, point_.size() - 1);
  }
  Vec2 direction_at(double at) const {
    const std::size_t after = point_after(at);
    return glm::normalize(point_[after] - point_[after - 1]);
  }
  Vec2 at(double place) const {
    const std::size_t after = point_after(place);
    return point_[after - 1] + (place - before_[after - 1]) * direction_at(place);
  }

 private:
  const std::vector<Vec2>& point_;
  std::vector<double> before_;
};

std::vector<Corner> corners_of(const std::vector<Vec2>& points, const Polyline& line) {
  std::vector<std::size_t> sharp;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    if (std::abs(std::atan2(cross(in, out), dot(in, out))) > least_turn) sharp.push_back(i);
  }
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < sharp.size();) {
    std::size_t end = i + 1;
    while (end < sharp.size() && line.before(sharp[end]) - line.before(sharp[i]) < same_corner)
      ++end;
    corners.push_back({.tip = sharp[(i + end - 1) / 2],
                       .first = line.before(sharp[i]),
                       .last = line.before(sharp[end - 1])});
    i = end;
  }
  return corners;
}

/// Neighbouring corners share the way between them; there is none beyond the first and the last.
void measure_legs(const FloorMap& map, double radius, const std::vector<Vec2>& points,
                  const Polyline& line, std::vector<Corner>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Corner& corner = corners[i];
    const double at = line.before(corner.tip);
    const double begin = i == 0 ? 0 : (corners[i - 1].last + corner.first) / 2;
    const double end =
        i + 1 == corners.size() ? line.length() : (corner.last + corners[i + 1].first) / 2;
    const double room = map.clearance_at(points[corner.tip]) - radius;
    corner.leg = std::min({longest_leg, at - begin, end - at, room});
  }
}

/// The cubic Bezier curve that leaves and joins the way at the ends of a corner's legs, along it:
/// with straight legs, nearly an arc. None where the legs are so short or bend so much that it
/// would not go round all of the corner inside the disc about its tip.
std::optional<std::array<Vec2, 4>> curve_about(const Corner& corner, Vec2 tip,
                                               const Polyline& line) {
  const double begin = line.before(corner.tip) - corner.leg;
  const double end = line.before(corner.tip) + corner.leg;
  if (corner.leg < shortest_leg || begin > corner.first || end < corner.last) return {};
  // The directions are those of the way inside the legs.
  const Vec2 leaving = line.direction_at(begin);
  const Vec2 joining = line.direction_at(std::nextafter(end, begin));
  const double turn = std::abs(std::atan2(cross(leaving, joining), dot(leaving, joining)));
  // For an arc, tan(turn / 4) / tan(turn / 2) * 4 / 3 of the leg, written so that it has no gap.
  const double tangent = std::tan(turn / 4);
  const double handle = corner.leg * (2.0 / 3) * (1 - tangent * tangent);
  const std::array<Vec2, 4> control{line.at(begin), line.at(begin) + handle * leaving,
                                    line.at(end) - handle * joining, line.at(end)};
  for (const Vec2 point : control)
    if (glm::distance(point, tip) > corner.leg + touching) return {};
  return control;
}

Vec2 point_on(const std::array<Vec2, 4>& control, double t) {
  const double s = 1 - t;
  return s * s * s * control[0] + 3 * s * s * t * control[1] + 3 * s * t * t * control[2] +
         t * t * t * control[3];
}

}  // namespace

void round_corners(const FloorMap& map, double radius, Way& way) {
  if (way.status != RouteStatus::Ok || way.points.size() < 3) return;
  constexpr int pieces = 18;  // flat to 1 mm for a quarter turn about 1 m
  const std::vector<Vec2> sharp = way.points;
  const Polyline line(sharp);
  std::vector<Corner> corners = corners_of(sharp, line);
  measure_legs(map, radius, sharp, line, corners);

  way.points.clear();
  std::size_t next = 0;
  for (const Corner& corner : corners) {
    const auto control = curve_about(corner, sharp[corner.tip], line);
    if (!control) continue;
    const double at = line.before(corner.tip);
    while (line.before(next) < at - corner.leg) append_point(sharp[next++], way.points);
    way.length -= 2 * corner.leg;
    Vec2 last = control->front();
    for (int i = 0; i <= pieces; ++i) {
      const Vec2 point = point_on(*control, static_cast<double>(i) / pieces);
      way.length += glm::distance(last, point);
      way.clearance_min = std::min(way.clearance_min, map.clearance_at(point));
      append_point(point, way.points);
      last = point;
    }
    next = line.point_after(at + corner.leg);
  }
  for (; next < sharp.size(); ++next) append_point(sharp[next], way.points);
  way.points.front() = sharp.front();
  way.points.back() = sharp.back();
}

}  // namespace docent::path
