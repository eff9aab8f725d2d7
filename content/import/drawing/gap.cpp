#include "content/import/drawing/gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "content/import/drawing/segment_grid.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

using Leaving = std::vector<std::vector<std::uint32_t>>;

double cosine(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}

constexpr double longest_table = 3.2, narrowest_table = 0.35;  ///< Metres.

/// A place where the line of a wall stops.
struct End {
  std::uint32_t vertex = 0;
  Vec2 along{};  ///< Of length 1, out of the wall.
  /// Of the wall that ends here, metres; 0 of a single line, nothing where only one face of a wall
  /// turns.
  std::optional<double> thickness{};
};

class Gaps {
 public:
  Gaps(const Arrangement& arrangement, double widest, double widest_side)
      : arrangement_(arrangement),
        widest_(widest),
        widest_side_(widest_side),
        leaving_(leaving_half_edges(arrangement)) {
    for (std::uint32_t e = 0; e < arrangement.edge.size(); ++e) edges_.add(e, from(e), to(e));
    find_small_parts();
  }

  std::vector<Gap> find() {
    find_ends();
    std::vector<Gap> gaps;
    for (std::uint32_t i = 0; i < ends_.size(); ++i)
      if (ends_[i].thickness)
        if (const auto gap = gap_from(i)) gaps.push_back(*gap);
    return gaps;
  }

 private:
  Vec2 at(std::uint32_t v) const { return arrangement_.vertex[v]; }
  Vec2 from(std::uint32_t e) const { return at(arrangement_.edge[e].from); }
  Vec2 to(std::uint32_t e) const { return at(arrangement_.edge[e].to); }
  Vec2 direction(std::uint32_t half) const {
    return glm::normalize(at(arrangement_.head(half)) - at(arrangement_.origin(half)));
  }

  /// Columns and the like, parts of the drawing that fit into 1.3 m; and what could be a table.
  void find_small_parts() {
    const std::size_t count = arrangement_.vertex.size();
    part_.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) part_[v] = v;
    const auto root = [&](std::uint32_t v) {
      while (part_[v] != v) v = part_[v] = part_[part_[v]];
      return v;
    };
    for (const ArrangementEdge& edge : arrangement_.edge) part_[root(edge.from)] = root(edge.to);
    // Measured along each part's own longest line, since drawings may be turned.
    std::vector<Vec2> along(count, Vec2(0));
    for (std::uint32_t e = 0; e < arrangement_.edge.size(); ++e) {
      Vec2& longest = along[root(arrangement_.edge[e].from)];
      if (glm::distance(from(e), to(e)) > glm::length(longest)) longest = to(e) - from(e);
    }
    std::vector<Vec2> low(count, Vec2(std::numeric_limits<double>::max()));
    std::vector<Vec2> high(count, Vec2(std::numeric_limits<double>::lowest()));
    for (std::uint32_t v = 0; v < count; ++v) {
      part_[v] = root(v);
      const Vec2 run = along[part_[v]];
      if (run == Vec2(0)) continue;
      const Vec2 p{dot(at(v), glm::normalize(run)), cross(glm::normalize(run), at(v))};
      low[part_[v]] = glm::min(low[part_[v]], p);
      high[part_[v]] = glm::max(high[part_[v]], p);
    }
    // A table has four corners; of walls about a corner of a room one is missing.
    std::vector<std::uint32_t> corners(count, 0);
    for (std::uint32_t v = 0; v < count; ++v) {
      const Vec2 run = along[part_[v]];
      if (run == Vec2(0)) continue;
      const Vec2 p{dot(at(v), glm::normalize(run)), cross(glm::normalize(run), at(v))};
      const Vec2 lower = low[part_[v]], upper = high[part_[v]];
      for (std::uint32_t corner = 0; corner < 4; ++corner)
        if (glm::distance(
                p, Vec2{corner % 2 == 0 ? lower.x : upper.x, corner < 2 ? lower.y : upper.y}) < 0.1)
          corners[part_[v]] |= 1U << corner;
    }
    small_.resize(count);
    stands_free_.resize(count);
    for (std::uint32_t v = 0; v < count; ++v) {
      const Vec2 size = high[part_[v]] - low[part_[v]];
      const double longer = std::max(size.x, size.y), shorter = std::min(size.x, size.y);
      small_[v] = longer < 1.3;
      stands_free_[v] =
          longer < longest_table && shorter > narrowest_table && corners[part_[v]] == 15;
    }
  }

  void find_ends() {
    for (std::uint32_t v = 0; v < leaving_.size(); ++v) {
      if (small_[v]) continue;
      for (const std::uint32_t half : leaving_[v]) {
        if (shuts(half)) continue;
        const Vec2 along = -direction(half);  // The line comes in along it.
        if (leaves(v, along, cosine(25))) continue;
        const bool loose = leaving_[v].size() == 1;
        ends_.push_back({v, along, loose ? std::optional(0.0) : ends_across(v, along)});
      }
    }
    for (std::uint32_t i = 0; i < ends_.size(); ++i)
      end_grid_.add(i, at(ends_[i].vertex), at(ends_[i].vertex));
  }

  bool shuts(std::uint32_t half) const {
    return arrangement_.edge[half / 2].kind >= first_closing_kind;
  }

  /// Does anything leave in that direction?
  bool leaves(std::uint32_t v, Vec2 along, double least) const {
    return std::ranges::any_of(
        leaving_[v], [&](std::uint32_t half) { return dot(direction(half), along) > least; });
  }

  /// Does a wall leave in that direction?
  bool goes_on(std::uint32_t v, Vec2 along, double least) const {
    return std::ranges::any_of(leaving_[v], [&](std::uint32_t half) {
      return !shuts(half) && dot(direction(half), along) > least;
    });
  }

  /// Does a short line leave across, from whose end another runs back beside the wall?
  std::optional<double> ends_across(std::uint32_t v, Vec2 along) const {
    for (const std::uint32_t first : leaving_[v]) {
      const Vec2 across = direction(first);
      if (std::abs(dot(across, along)) > cosine(60)) continue;
      // Between two doors, a wall's face is short, too; shut doors show that it goes on.
      if (leaves(v, -across, cosine(25))) continue;
      std::uint32_t half = first;
      double width = 0;
      for (int steps = 0; steps < 12; ++steps) {
        const std::uint32_t end = arrangement_.head(half);
        width += glm::length(at(end) - at(arrangement_.origin(half)));
        if (width > thickest_wall) break;
        if (width > 0.03 && goes_on(end, -along, cosine(15)) && !goes_on(end, along, cosine(25)) &&
            !leaves(end, across, cosine(25)))
          return width;
        const auto next = std::ranges::find_if(
            leaving_[end], [&](std::uint32_t h) { return dot(direction(h), across) > cosine(10); });
        if (next == leaving_[end].end()) break;
        half = *next;
      }
    }
    return std::nullopt;
  }

  std::optional<Gap> gap_from(std::uint32_t index) const {
    const End& end = ends_[index];
    const Vec2 a = at(end.vertex);
    const double first = first_hit(a, end.along, widest_);
    std::optional<Gap> best;
    double nearest = std::min(widest_, first + 0.02);
    end_grid_.near(a, a + widest_ * end.along, 0.1, [&](std::uint32_t i) {
      const End& other = ends_[i];
      const Vec2 to = at(other.vertex) - a;
      const double ahead = dot(to, end.along);
      if (ahead < narrowest_gap || ahead > nearest || std::abs(cross(end.along, to)) > 0.06 ||
          dot(other.along, end.along) > -cosine(15))
        return;
      // A pier faces one like it; between a table and a wall is no door.
      if ((stands_free_[end.vertex] || stands_free_[other.vertex]) &&
          (!other.thickness || std::abs(*other.thickness - *end.thickness) > 0.05))
        return;
      nearest = ahead;
      best = Gap{a, at(other.vertex), other.thickness.has_value()};
    });
    if (best) return best;
    if (first < narrowest_gap || first > widest_side_ || stands_free_[end.vertex])
      return std::nullopt;
    return Gap{a, a + first * end.along, false};
  }

  /// How far one sees from `a`, in front of the wall's end.
  double first_hit(Vec2 a, Vec2 along, double most) const {
    double best = most + 1;
    const Vec2 begin = a + 0.02 * along, goal = a + most * along;
    edges_.near(begin, goal, 0, [&](std::uint32_t e) {
      const Vec2 p = from(e), q = to(e), pq = q - p;
      const double denominator = cross(goal - begin, pq);
      if (std::abs(denominator) < 0.2 * glm::length(pq) * (most - 0.02)) return;
      const double t = cross(p - begin, pq) / denominator;
      const double u = cross(p - begin, goal - begin) / denominator;
      if (t < 0 || t > 1 || u < -0.001 || u > 1.001) return;
      best = std::min(best, 0.02 + t * (most - 0.02));
    });
    return best;
  }

  const Arrangement& arrangement_;
  double widest_, widest_side_;
  Leaving leaving_;
  SegmentGrid edges_{1}, end_grid_{1};
  std::vector<std::uint32_t> part_;
  std::vector<bool> small_, stands_free_;
  std::vector<End> ends_;
};

}  // namespace

std::vector<Gap> find_gaps(const Arrangement& arrangement, double widest, double widest_side) {
  return Gaps(arrangement, widest, widest_side).find();
}

std::vector<Gap> find_slips(const Arrangement& arrangement, double reach) {
  std::vector<std::uint32_t> degree(arrangement.vertex.size(), 0), only(degree.size(), 0);
  SegmentGrid grid(0.5);
  for (std::uint32_t e = 0; e < arrangement.edge.size(); ++e) {
    const ArrangementEdge& edge = arrangement.edge[e];
    grid.add(e, arrangement.vertex[edge.from], arrangement.vertex[edge.to]);
    for (const std::uint32_t v : {edge.from, edge.to}) {
      ++degree[v];
      only[v] = e;
    }
  }
  std::vector<Gap> slips;
  for (std::uint32_t v = 0; v < degree.size(); ++v) {
    if (degree[v] != 1) continue;
    const Vec2 p = arrangement.vertex[v];
    double best = reach;
    std::optional<Vec2> place;
    grid.near(p, p, reach, [&](std::uint32_t e) {
      if (e == only[v]) return;
      const Vec2 a = arrangement.vertex[arrangement.edge[e].from];
      const Vec2 b = arrangement.vertex[arrangement.edge[e].to];
      const NearestOnSegment nearest = nearest_on_segment(p, a, b);
      const double apart = std::sqrt(nearest.distance_squared);
      if (apart >= best || apart < 1e-6) return;
      best = apart;
      place = a + nearest.t * (b - a);
    });
    if (place) slips.push_back({p, *place, true});
  }
  return slips;
}

}  // namespace docent::import
