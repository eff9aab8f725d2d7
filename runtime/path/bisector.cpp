#include "runtime/path/bisector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/path/flatten.h"

namespace docent {
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

Bisector::Bisector(const FloorPlan& plan, const VoronoiDiagram& diagram, const VoronoiEdge& edge) {
  const Vec2 from = diagram.vertex[edge.from], to = diagram.vertex[edge.to];
  Site corner = diagram.site[edge.left], other = diagram.site[edge.right];
  if (corner.kind == Site::Kind::Wall) std::swap(corner, other);
  low_ = glm::min(from, to);
  high_ = glm::max(from, to);

  if (edge.parabola) {
    const Vec2 focus = plan.vertex[corner.index];
    const Vec2 a = wall_start(plan, other.index), b = wall_end(plan, other.index);
    along_ = glm::normalize(b - a);
    up_ = left_of(along_);
    height_ = dot(focus - a, up_);
    if (height_ > 0) {
      kind_ = Kind::Parabola;
      origin_ = focus - height_ * up_;
      begin_ = dot(from - origin_, along_);
      end_ = dot(to - origin_, along_);
      // The curve lies in the triangle of its ends and the place where its end tangents meet.
      const double meet_x = (begin_ + end_) / 2;
      const double meet_y = (begin_ * end_ + height_ * height_) / (2 * height_);
      const Vec2 meet = origin_ + meet_x * along_ + meet_y * up_;
      low_ = glm::min(low_, meet);
      high_ = glm::max(high_, meet);
      return;
    }
  }
  const double length = glm::length(to - from);
  origin_ = from;
  if (length > 0) along_ = (to - from) / length;
  up_ = left_of(along_);
  end_ = length;
  if (corner.kind == Site::Kind::Corner && other.kind == Site::Kind::Corner) {
    kind_ = Kind::Corners;
    const Vec2 to_corner = plan.vertex[corner.index] - from;
    middle_ = dot(to_corner, along_);
    height_ = std::abs(cross(along_, to_corner));
  } else {
    begin_clearance_ = diagram.clearance[edge.from];
    if (length > 0) slope_ = (diagram.clearance[edge.to] - begin_clearance_) / length;
  }
}

double Bisector::clamped(double place) const noexcept {
  return std::clamp(place, std::min(begin_, end_), std::max(begin_, end_));
}

Vec2 Bisector::point_at(double place) const noexcept {
  if (kind_ == Kind::Parabola) return origin_ + place * along_ + clearance_at(place) * up_;
  return origin_ + place * along_;
}

double Bisector::clearance_at(double place) const noexcept {
  switch (kind_) {
    case Kind::Parabola:
      return (place * place / height_ + height_) / 2;
    case Kind::Corners:
      return std::hypot(height_, place - middle_);
    case Kind::Linear:
      break;
  }
  return begin_clearance_ + slope_ * place;
}

double Bisector::length_between(double a, double b) const noexcept {
  if (kind_ != Kind::Parabola) return std::abs(b - a);
  // The integral of sqrt(1 + (x/h)^2).
  const auto from_lowest = [this](double x) {
    const double t = x / height_;
    return height_ / 2 * (t * std::sqrt(1 + t * t) + std::asinh(t));
  };
  return std::abs(from_lowest(b) - from_lowest(a));
}

double Bisector::lowest_place() const noexcept {
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

double Bisector::clearance_between(double a, double b) const noexcept {
  const double lowest = std::clamp(lowest_place(), std::min(a, b), std::max(a, b));
  return std::min({clearance_at(a), clearance_at(b), clearance_at(lowest)});
}

double Bisector::nearest_place(Vec2 point) const noexcept {
  const Vec2 from_origin = point - origin_;
  const double x = dot(from_origin, along_), y = dot(from_origin, up_);
  if (kind_ != Kind::Parabola) return clamped(x);
  // Where the line to the point is normal to the curve: x'^3 + (3 h^2 - 2 h y) x' - 2 h^2 x = 0.
  const double h = height_;
  const Roots normals = depressed_cubic(3 * h * h - 2 * h * y, -2 * h * h * x);
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

double Bisector::place_of_clearance(double level, double a, double b) const noexcept {
  const auto on_side = [&](double centre, double away) {
    const double place = (a + b) / 2 < centre ? centre - away : centre + away;
    return std::clamp(place, std::min(a, b), std::max(a, b));
  };
  switch (kind_) {
    case Kind::Parabola:
      return on_side(0, std::sqrt(std::max(0.0, height_ * (2 * level - height_))));
    case Kind::Corners:
      return on_side(middle_, std::sqrt(std::max(0.0, level * level - height_ * height_)));
    case Kind::Linear:
      break;
  }
  if (slope_ == 0) return a;
  return std::clamp((level - begin_clearance_) / slope_, std::min(a, b), std::max(a, b));
}

void Bisector::append_points(double a, double b, std::vector<Vec2>& points) const {
  append_point(point_at(a), points);
  if (kind_ == Kind::Parabola) {
    // A chord over dx is at most dx^2 / (8 h) from the parabola.
    const double step = std::sqrt(8 * height_ * flatness);
    const int pieces = static_cast<int>(std::min(1e5, std::ceil(std::abs(b - a) / step)));
    for (int i = 1; i < pieces; ++i) append_point(point_at(a + (b - a) * i / pieces), points);
  }
  append_point(point_at(b), points);
}

}  // namespace docent
