#include "content/scenery/flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "runtime/model/geometry/treads.h"

namespace docent::scenery {
namespace {

constexpr double rail_height = 0.95;
constexpr double rail_width = 0.05;
constexpr double balustrade_width = 0.14;  // an escalator's
constexpr double level_before = 0.5;       // metres that an escalator's handrail runs level

/// The part of a convex outline where `limit` <= p * direction; empty where there is none.
Outline beyond(const Outline& outline, Vec2 direction, double limit) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i];
    const Vec2 b = outline[(i + 1) % outline.size()];
    const double from = dot(a, direction) - limit;
    const double to = dot(b, direction) - limit;
    if (from >= 0) kept.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0))
      kept.push_back(a + (b - a) * (from / (from - to)));
  }
  return kept.size() < 3 ? Outline{} : kept;
}

struct Extent {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
};

Extent extent_along(const Outline& outline, Vec2 direction) {
  Extent extent;
  for (const Vec2 p : outline) {
    extent.low = std::min(extent.low, dot(p, direction));
    extent.high = std::max(extent.high, dot(p, direction));
  }
  return extent;
}

/// Builds one flight. Distances are metres from its near end, where one goes in.
class FlightBuilder {
 public:
  FlightBuilder(const Flight& flight, MeshBuilder& mesh, std::vector<Blocker>& blockers)
      : footprint_(flight.footprint), kind_(flight.passage.kind), mesh_(mesh), blockers_(blockers) {
    const Vec2 way = flight.passage.there - flight.passage.here.position;
    along_ = way / std::hypot(way.x, way.y);
    const Extent extent = extent_along(footprint_, along_);
    near_ = extent.low;
    length_ = extent.high - extent.low;
    rise_ = flight.passage.rise;
    treads_ = treads_within(footprint_, flight.passage.here.position, flight.passage.there, rise_);
  }

  void build() {
    if (rise_ > 0)
      build_up();
    else
      build_down();
    if (kind_ == ConnectionKind::Escalator) build_balustrades();
  }

 private:
  [[nodiscard]] Outline slice(const Outline& outline, double from, double to) const {
    const Outline rest = beyond(outline, along_, near_ + from);
    return beyond(rest, -along_, -(near_ + to));
  }
  [[nodiscard]] double distance_of(Vec2 p) const { return dot(p, along_) - near_; }
  [[nodiscard]] double slope_at(double distance) const {
    return rise_ * std::clamp(distance / length_, 0.0, 1.0);
  }

  /// A solid between two surfaces that depend on the distance alone.
  void solid(const Outline& outline, Surface top_surface, const std::function<double(double)>& base,
             const std::function<double(double)>& top) {
    if (outline.empty()) return;
    const auto low = [&](Vec2 p) { return to_world(p, base(distance_of(p))); };
    const auto high = [&](Vec2 p) { return to_world(p, top(distance_of(p))); };
    mesh_.use(kind_ == ConnectionKind::Escalator ? Surface::CaseBody : Surface::Plaster);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i];
      const Vec2 b = outline[(i + 1) % outline.size()];
      mesh_.quad({low(a), low(b), high(b), high(a)});
    }
    mesh_.use(top_surface);
    for (std::size_t i = 2; i < outline.size(); ++i) {
      const std::array<Vec3, 3> corner{high(outline[0]), high(outline[i - 1]), high(outline[i])};
      const Vec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
      const float size = std::sqrt(glm::dot(normal, normal));
      if (size > 1e-9F) mesh_.triangle(corner, normal / size);
    }
  }

  void step(const Outline& tread, double base, double height) {
    if (tread.empty()) return;
    mesh_.use(Surface::Plaster);
    mesh_.sides(tread, std::array{base, height});
    pave(tread, height);
    blockers_.push_back({tread, height});
  }

  /// A level face in pieces across the way, at whose corners light is kept.
  void pave(const Outline& face, double height) {
    constexpr double piece = 0.4;
    const Vec2 across = left_of(along_);
    const Extent sides = extent_along(face, across);
    const int count = std::max(1, static_cast<int>(std::ceil((sides.high - sides.low) / piece)));
    mesh_.use(Surface::CaseBody);
    for (int i = 0; i < count; ++i) {
      const double from = sides.low + (sides.high - sides.low) * i / count;
      const double to = sides.low + (sides.high - sides.low) * (i + 1) / count;
      flat(beyond(beyond(face, across, from), -across, -to), height);
    }
  }

  void flat(const Outline& face, double height) {
    for (std::size_t i = 2; i < face.size(); ++i)
      mesh_.triangle(
          {to_world(face[0], height), to_world(face[i - 1], height), to_world(face[i], height)},
          {0, 1, 0});
  }

  /// The part of the footprint that is a tread.
  [[nodiscard]] Outline tread(int i) const {
    return slice(footprint_, i * treads_.depth(), (i + 1) * treads_.depth());
  }

  void build_up() {
    const double cut_at = std::min(length_, length_ * cut_height / rise_);
    if (kind_ == ConnectionKind::Ramp) {
      const Outline sloping = slice(footprint_, 0, cut_at);
      solid(
          sloping, Surface::CaseBody, [](double) { return 0.0; },
          [this](double distance) { return slope_at(distance); });
      blockers_.push_back({sloping, std::min(rise_, cut_height) / 2});
    } else {
      for (int i = 0; i < treads_.count && treads_.height_of(i) < cut_height + 1e-9; ++i)
        step(tread(i), 0, treads_.height_of(i));
    }
    build_cut(kind_ == ConnectionKind::Ramp
                  ? cut_at
                  : std::floor(cut_at / treads_.depth() + 1e-9) * treads_.depth());
  }

  /// What goes on above the height of the cut: solid, with the further steps as lines, as plans
  /// show them.
  void build_cut(double from) {
    const Outline rest = slice(footprint_, from, length_);
    if (rest.empty() || rise_ <= cut_height) return;
    mesh_.use(Surface::Plaster);
    mesh_.sides(rest, std::array{0.0, 0.1, 0.3, 0.7, cut_height});
    blockers_.push_back({rest, cut_height});
    constexpr double line = 0.035;
    constexpr double above = 0.003;
    for (double at = from; at < length_ - line; at += treads_.depth()) {
      pave(slice(footprint_, at, std::min(length_, at + treads_.depth())), cut_height);
      if (kind_ == ConnectionKind::Ramp) continue;
      mesh_.use(Surface::CutFace);
      flat(slice(footprint_, at, at + line), cut_height + above);
    }
  }

  void build_down() {
    build_shaft();
    if (kind_ == ConnectionKind::Ramp) {
      solid(
          footprint_, Surface::CaseBody, [this](double) { return rise_; },
          [this](double distance) { return slope_at(distance); });
      blockers_.push_back({footprint_, rise_ / 2});
    } else {
      for (int i = 0; i < treads_.count; ++i)
        step(tread(i), treads_.height_of(i + 1), treads_.height_of(i));
    }
    build_rail();
  }

  /// The opening's sides, seen from within.
  void build_shaft() {
    std::vector<double> rows;
    for (const double depth : {0.0, 0.15, 0.5, 1.0, 1.8, 2.8, 4.0})
      if (-depth > rise_) rows.insert(rows.begin(), -depth);
    rows.insert(rows.begin(), rise_);
    mesh_.use(Surface::Plaster);
    for (std::size_t i = 0; i < footprint_.size(); ++i)
      mesh_.wall(footprint_[(i + 1) % footprint_.size()], footprint_[i], rows);
  }

  /// Glass and a handrail along all sides but the one where one goes in.
  void build_rail() {
    for (std::size_t i = 0; i < footprint_.size(); ++i) {
      const Vec2 a = footprint_[i];
      const Vec2 b = footprint_[(i + 1) % footprint_.size()];
      if (distance_of((a + b) / 2.0) < 0.05 * length_) continue;
      mesh_.use(Surface::Glass);
      mesh_.glass_opacity(34);
      mesh_.quad({to_world(a, 0.04), to_world(b, 0.04), to_world(b, rail_height),
                  to_world(a, rail_height)});
      const Vec2 side = b - a;
      const Outline bar =
          rectangle((a + b) / 2.0, std::atan2(side.y, side.x),
                    {rail_width / 2, (std::hypot(side.x, side.y) + rail_width) / 2});
      mesh_.use(Surface::Frame);
      mesh_.sides(bar, std::array{rail_height, rail_height + rail_width});
      mesh_.lid(bar, rail_height + rail_width);
    }
  }

  /// An escalator's sides, as high as a hand; cut at the height of the walls, too.
  void build_balustrades() {
    const auto top = [this](double distance) {
      return std::min(rail_height + slope_at(std::max(0.0, distance - level_before)), cut_height);
    };
    const auto base = [this, &top](double distance) {
      return rise_ > 0 ? 0.0 : std::min(slope_at(distance), top(distance) - 1);
    };
    const double cut_at =
        rise_ > 0 ? std::min(length_, level_before + (cut_height - rail_height) / rise_ * length_)
                  : length_;
    const Vec2 across = left_of(along_);
    const Extent sides = extent_along(footprint_, across);
    for (const Outline& strip : {beyond(footprint_, across, sides.high - balustrade_width),
                                 beyond(footprint_, -across, -(sides.low + balustrade_width))}) {
      solid(slice(strip, 0, level_before), Surface::Frame, base, top);
      solid(slice(strip, level_before, cut_at), Surface::Frame, base, top);
      if (cut_at < length_) solid(slice(strip, cut_at, length_), Surface::CutFace, base, top);
    }
  }

  const Outline& footprint_;
  ConnectionKind kind_;
  MeshBuilder& mesh_;
  std::vector<Blocker>& blockers_;
  Vec2 along_{};
  double near_ = 0, length_ = 0, rise_ = 0;
  Treads treads_;
};

}  // namespace

std::optional<Flight> flight_of(const FloorPlan& plan, const Passage& passage) {
  const Vec2 here = passage.here.position;
  if (passage.kind == ConnectionKind::Lift || passage.rise == 0 || here == passage.there) return {};
  std::optional<Hole> hole = hole_between(plan, here, passage.there);
  if (!hole) return {};
  return Flight{passage, hole->ring, std::move(hole->outline)};
}

void build_flight(const Flight& flight, MeshBuilder& mesh, std::vector<Blocker>& blockers) {
  FlightBuilder(flight, mesh, blockers).build();
}

}  // namespace docent::scenery
