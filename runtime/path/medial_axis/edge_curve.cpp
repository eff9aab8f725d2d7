#include "runtime/path/medial_axis/edge_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/path/flatten.h"

namespace docent::path {
namespace {

/// The real roots of x^3 + p x + q (Cardano, Vieta).
struct Roots {
  std::array<double, 3> root{};
  std::size_t count = 0;
};

Roots depressed_cubic(double p, double q) noexcept {
  const double discriminant = q * q / 4 + p * p * p / 27;
  if (discriminant >= 0) {
    const double s = std::sqrt(discriminant);
    // Of the two cube roots take the one without cancellation and derive the other from it.
    const double larger = std::cbrt(q > 0 ? -q / 2 - s : -q / 2 + s);
    return {{larger == 0 ? 0 : larger - p / (3 * larger)}, 1};
  }
  const double radius = 2 * std::sqrt(-p / 3);
  const double angle = std::acos(std::clamp(3 * q / (p * radius), -1.0, 1.0)) / 3;
  Roots roots{.count = 3};
  for (std::size_t k = 0; k < 3; ++k)
    roots.root[k] = radius * std::cos(angle - 2 * std::numbers::pi / 3 * static_cast<double>(k));
  return roots;
}

}  // namespace

EdgeCurve::EdgeCurve(const FloorPlan& plan, const VoronoiDiagram& diagram,
                     const VoronoiEdge& edge) {
  const Vec2 from = diagram.vertex[edge.from], to = diagram.vertex[edge.to];
  low_ = glm::min(from, to);
  high_ = glm::max(from, to);
  if (edge.parabola) {
    kind_ = Kind::Parabola;
    parabola_ = parabola_of(plan, diagram, edge);
    begin_ = parameter_at(parabola_, from);
    end_ = parameter_at(parabola_, to);
    // The curve lies in the triangle of its ends and the place where its end tangents meet.
    const Vec2 meet = control_point(parabola_, begin_, end_);
    low_ = glm::min(low_, meet);
    high_ = glm::max(high_, meet);
    return;
  }
  const double length = glm::length(to - from);
  origin_ = from;
  if (length > 0) along_ = (to - from) / length;
  end_ = length;
  const Site left = diagram.site[edge.left], right = diagram.site[edge.right];
  if (left.kind == Site::Kind::Corner && right.kind == Site::Kind::Corner) {
    kind_ = Kind::Corners;
    const Vec2 to_corner = plan.vertex[left.index] - from;
    middle_ = dot(to_corner, along_);
    half_distance_ = std::abs(cross(along_, to_corner));
  } else {
    begin_clearance_ = diagram.clearance[edge.from];
    if (length > 0) slope_ = (diagram.clearance[edge.to] - begin_clearance_) / length;
  }
}

double EdgeCurve::clamped(double place) const noexcept {
  return std::clamp(place, std::min(begin_, end_), std::max(begin_, end_));
}

Vec2 EdgeCurve::point_at(double place) const noexcept {
  if (kind_ == Kind::Parabola) return docent::point_at(parabola_, place);
  return origin_ + place * along_;
}

double EdgeCurve::clearance_at(double place) const noexcept {
  switch (kind_) {
    case Kind::Parabola:
      return docent::clearance_at(parabola_, place);
    case Kind::Corners:
      return std::hypot(half_distance_, place - middle_);
    case Kind::Linear:
      break;
  }
  return begin_clearance_ + slope_ * place;
}

double EdgeCurve::length_between(double a, double b) const noexcept {
  return kind_ == Kind::Parabola ? arc_length(parabola_, a, b) : std::abs(b - a);
}

double EdgeCurve::lowest_place() const noexcept {
  switch (kind_) {
    case Kind::Parabola:
      return clamped(0);
    case Kind::Corners:
      return clamped(middle_);
    case Kind::Linear:
      break;
  }
  return slope_ < 0 ? end_ : begin_;
}

double EdgeCurve::clearance_between(double a, double b) const noexcept {
  const double lowest = std::clamp(lowest_place(), std::min(a, b), std::max(a, b));
  return std::min({clearance_at(a), clearance_at(b), clearance_at(lowest)});
}

double EdgeCurve::nearest_place(Vec2 point) const noexcept {
  if (kind_ != Kind::Parabola) return clamped(dot(point - origin_, along_));
  // Where the line to the point (x, y) is normal to the curve: u^3 + (3 p^2 - 2 p y) u = 2 p^2 x.
  const double x = parameter_at(parabola_, point);
  const double y = dot(point - parabola_.foot, parabola_.across), p = parabola_.p;
  const Roots normals = depressed_cubic(3 * p * p - 2 * p * y, -2 * p * p * x);
  double best = begin_, best_squared = -1;
  const auto consider = [&](double place) {
    const Vec2 apart = point_at(place) - point;
    if (best_squared >= 0 && dot(apart, apart) >= best_squared) return;
    best_squared = dot(apart, apart);
    best = place;
  };
  consider(begin_);
  consider(end_);
  for (std::size_t i = 0; i < normals.count; ++i)
    if (normals.root[i] == clamped(normals.root[i])) consider(normals.root[i]);
  return best;
}

double EdgeCurve::place_of_clearance(double level, double a, double b) const noexcept {
  const auto on_side = [&](double centre, double away) {
    const double place = (a + b) / 2 < centre ? centre - away : centre + away;
    return std::clamp(place, std::min(a, b), std::max(a, b));
  };
  switch (kind_) {
    case Kind::Parabola:
      return on_side(0, std::sqrt(std::max(0.0, parabola_.p * (2 * level - parabola_.p))));
    case Kind::Corners:
      return on_side(middle_,
                     std::sqrt(std::max(0.0, level * level - half_distance_ * half_distance_)));
    case Kind::Linear:
      break;
  }
  if (slope_ == 0) return a;
  return std::clamp((level - begin_clearance_) / slope_, std::min(a, b), std::max(a, b));
}

void EdgeCurve::append_inner_points(double a, double b, std::vector<Vec2>& points) const {
  if (kind_ != Kind::Parabola) return;
  // A chord over du is at most du^2 / (8 p) from the parabola.
  const double step = std::sqrt(8 * parabola_.p * flatness);
  const int pieces = static_cast<int>(std::min(1e5, std::ceil(std::abs(b - a) / step)));
  for (int i = 1; i < pieces; ++i) append_point(point_at(a + (b - a) * i / pieces), points);
}

void EdgeCurve::append_points(double a, double b, std::vector<Vec2>& points) const {
  append_point(point_at(a), points);
  append_inner_points(a, b, points);
  append_point(point_at(b), points);
}

}  // namespace docent::path
