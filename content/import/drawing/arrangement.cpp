#include "content/import/drawing/arrangement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>
#include <utility>

#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/segment_grid.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::import {
namespace {

constexpr std::size_t most_pieces = 400'000;

/// Points of the plane, those within snap_distance of one another being one.
class Vertices {
 public:
  explicit Vertices(Arrangement& out) : out_(out) {}

  std::uint32_t at(Vec2 p) {
    const std::int64_t x = cell(p.x), y = cell(p.y);
    for (std::int64_t row = y - 1; row <= y + 1; ++row)
      for (std::int64_t column = x - 1; column <= x + 1; ++column)
        if (const auto found = cells_.find(key(column, row)); found != cells_.end())
          for (const std::uint32_t v : found->second)
            if (const double apart = glm::length(out_.vertex[v] - p); apart < snap_distance) {
              if (apart > 1e-9) ++out_.snapped;
              return v;
            }
    const auto v = static_cast<std::uint32_t>(out_.vertex.size());
    out_.vertex.push_back(p);
    cells_[key(x, y)].push_back(v);
    return v;
  }

 private:
  static std::int64_t cell(double x) {
    return static_cast<std::int64_t>(std::floor(x / snap_distance));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(y) << 32U) ^ (static_cast<std::uint64_t>(x) & 0xffffffffU);
  }
  Arrangement& out_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// Where p q and a b cross, as parts of each.
std::optional<std::pair<double, double>> crossing(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  const Vec2 pq = q - p, ab = b - a;
  const double denominator = cross(pq, ab);
  // A line without length crosses nothing: here both sides are 0.
  if (!(std::abs(denominator) > 1e-9 * glm::length(pq) * glm::length(ab))) return std::nullopt;
  const double t = cross(a - p, ab) / denominator, u = cross(a - p, pq) / denominator;
  if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
  return std::pair{t, u};
}

/// One round of cutting. Snapping moves lines by up to its distance, which can make new crossings;
/// a second round finds those.
std::optional<Arrangement> cut(std::span<const WallLine> lines) {
  Arrangement out;
  Vertices vertices(out);
  std::vector<std::vector<std::uint32_t>> on(lines.size());
  double length = 0;
  for (const WallLine& line : lines) length += glm::length(line.b - line.a);
  SegmentGrid grid(std::max(0.5, length / 1e6));  // Never more than a few million cells.
  for (std::uint32_t i = 0; i < lines.size(); ++i) grid.add(i, lines[i].a, lines[i].b);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    on[i].push_back(vertices.at(lines[i].a));
    on[i].push_back(vertices.at(lines[i].b));
  }
  const std::size_t ends = out.vertex.size();
  for (std::uint32_t v = 0; v < ends; ++v)
    grid.near(out.vertex[v], out.vertex[v], snap_distance, [&](std::uint32_t i) {
      if (distance_to_segment(out.vertex[v], lines[i].a, lines[i].b) < snap_distance)
        on[i].push_back(v);
    });
  std::size_t pieces = 0;
  std::vector<std::uint32_t> seen(lines.size(), no_face);
  for (std::uint32_t i = 0; i < lines.size() && pieces < most_pieces; ++i)
    grid.near(lines[i].a, lines[i].b, 0, [&](std::uint32_t j) {
      if (j <= i || seen[j] == i) return;
      seen[j] = i;
      const auto at = crossing(lines[i].a, lines[i].b, lines[j].a, lines[j].b);
      if (!at) return;
      const std::uint32_t v = vertices.at(lines[i].a + at->first * (lines[i].b - lines[i].a));
      on[i].push_back(v);
      on[j].push_back(v);
      ++pieces;
    });
  if (pieces >= most_pieces) return std::nullopt;

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const Vec2 a = lines[i].a, along = lines[i].b - a;
    std::vector<std::uint32_t>& stops = on[i];
    std::ranges::sort(stops, {},
                      [&](std::uint32_t v) { return std::pair{dot(out.vertex[v] - a, along), v}; });
    const auto [repeated, end] = std::ranges::unique(stops);
    stops.erase(repeated, end);
    for (std::size_t k = 1; k < stops.size(); ++k) {
      const std::uint32_t from = std::min(stops[k - 1], stops[k]);
      const std::uint32_t to = std::max(stops[k - 1], stops[k]);
      if (from == to) continue;
      const auto [found, fresh] = edges.try_emplace({from, to}, lines[i].kind);
      if (!fresh) found->second = std::min(found->second, lines[i].kind);
    }
  }
  if (edges.size() > most_pieces) return std::nullopt;
  for (const auto& [ends_of, kind] : edges)
    out.edge.push_back({ends_of.first, ends_of.second, kind});
  return out;
}

double cycle_area(const Arrangement& arrangement, std::span<const std::uint32_t> cycle) {
  const Vec2 first = arrangement.vertex[arrangement.origin(cycle.front())];
  double doubled = 0;
  for (const std::uint32_t half : cycle)
    doubled += cross(arrangement.vertex[arrangement.origin(half)] - first,
                     arrangement.vertex[arrangement.head(half)] - first);
  return doubled / 2;
}

std::vector<Vec2> ring_of(const Arrangement& arrangement, std::span<const std::uint32_t> cycle) {
  std::vector<Vec2> ring;
  for (const std::uint32_t half : cycle)
    ring.push_back(arrangement.vertex[arrangement.origin(half)]);
  return ring;
}

/// Which connected part of the drawing each vertex belongs to.
std::vector<std::uint32_t> parts_of(const Arrangement& arrangement) {
  std::vector<std::uint32_t> part(arrangement.vertex.size());
  for (std::uint32_t v = 0; v < part.size(); ++v) part[v] = v;
  const auto root = [&](std::uint32_t v) {
    while (part[v] != v) v = part[v] = part[part[v]];
    return v;
  };
  for (const ArrangementEdge& edge : arrangement.edge) part[root(edge.from)] = root(edge.to);
  for (std::uint32_t v = 0; v < part.size(); ++v) part[v] = root(v);
  return part;
}

/// Puts each clockwise cycle as a hole into the smallest face around it.
void place_holes(const Arrangement& arrangement, Faces& faces,
                 std::vector<std::vector<std::uint32_t>>& holes) {
  const std::vector<std::uint32_t> part = parts_of(arrangement);
  std::vector<std::vector<Vec2>> rings;
  std::vector<DrawnBox> boxes;
  for (const Face& face : faces.face) {
    rings.push_back(ring_of(arrangement, face.outer));
    DrawnBox box;
    for (const Vec2 p : rings.back()) box.add(p);
    boxes.push_back(box);
  }
  std::vector<double> own_area;
  for (const Face& face : faces.face) own_area.push_back(face.area);
  for (std::vector<std::uint32_t>& hole : holes) {
    const std::uint32_t v = arrangement.origin(hole.front());
    std::uint32_t best = no_face;
    for (std::uint32_t f = 0; f < faces.face.size(); ++f)
      if ((best == no_face || own_area[f] < own_area[best]) &&
          boxes[f].holds(arrangement.vertex[v]) &&
          part[arrangement.origin(faces.face[f].outer.front())] != part[v] &&
          contains(rings[f], arrangement.vertex[v]))
        best = f;
    for (const std::uint32_t half : hole) faces.face_of[half] = best;
    if (best == no_face) continue;
    faces.face[best].area += cycle_area(arrangement, hole);
    faces.face[best].holes.push_back(std::move(hole));
  }
}

}  // namespace

std::vector<WallLine> lines_of(const Arrangement& arrangement) {
  std::vector<WallLine> lines;
  for (const ArrangementEdge& edge : arrangement.edge)
    lines.push_back({arrangement.vertex[edge.from], arrangement.vertex[edge.to], edge.kind});
  return lines;
}

std::optional<Arrangement> arrange(std::span<const WallLine> lines) {
  std::optional<Arrangement> once = cut(lines);
  for (int round = 0; once && round < 2; ++round) {
    const std::size_t snapped = once->snapped;
    once = cut(lines_of(*once));
    if (once) once->snapped = snapped;
  }
  return once;
}

std::size_t trim_overruns(Arrangement& arrangement, double reach) {
  std::vector<std::uint32_t> degree(arrangement.vertex.size(), 0);
  for (const ArrangementEdge& edge : arrangement.edge) {
    ++degree[edge.from];
    ++degree[edge.to];
  }
  return std::erase_if(arrangement.edge, [&](const ArrangementEdge& edge) {
    const auto [free, held] = std::minmax(degree[edge.from], degree[edge.to]);
    return free == 1 && held >= 3 &&
           glm::distance(arrangement.vertex[edge.from], arrangement.vertex[edge.to]) < reach;
  });
}

std::size_t remove_loose_pieces(Arrangement& arrangement) {
  std::vector<std::vector<std::uint32_t>> at(arrangement.vertex.size());
  for (std::uint32_t e = 0; e < arrangement.edge.size(); ++e) {
    at[arrangement.edge[e].from].push_back(e);
    at[arrangement.edge[e].to].push_back(e);
  }
  std::vector<std::size_t> degree(at.size());
  std::vector<std::uint32_t> loose;
  for (std::uint32_t v = 0; v < at.size(); ++v) {
    degree[v] = at[v].size();
    if (degree[v] == 1) loose.push_back(v);
  }
  std::vector<bool> gone(arrangement.edge.size(), false);
  while (!loose.empty()) {
    const std::uint32_t v = loose.back();
    loose.pop_back();
    for (const std::uint32_t e : at[v]) {
      if (gone[e]) continue;
      gone[e] = true;
      for (const std::uint32_t end : {arrangement.edge[e].from, arrangement.edge[e].to})
        if (--degree[end] == 1) loose.push_back(end);
    }
  }
  std::vector<ArrangementEdge> kept;
  for (std::uint32_t e = 0; e < arrangement.edge.size(); ++e)
    if (!gone[e]) kept.push_back(arrangement.edge[e]);
  const std::size_t removed = arrangement.edge.size() - kept.size();
  arrangement.edge = std::move(kept);
  return removed;
}

std::vector<std::vector<std::uint32_t>> leaving_half_edges(const Arrangement& arrangement) {
  std::vector<std::vector<std::uint32_t>> leaving(arrangement.vertex.size());
  for (std::uint32_t e = 0; e < arrangement.edge.size(); ++e) {
    leaving[arrangement.edge[e].from].push_back(2 * e);
    leaving[arrangement.edge[e].to].push_back(2 * e + 1);
  }
  for (std::vector<std::uint32_t>& halves : leaving)
    std::ranges::sort(halves, {}, [&](std::uint32_t half) {
      const Vec2 along =
          arrangement.vertex[arrangement.head(half)] - arrangement.vertex[arrangement.origin(half)];
      return std::atan2(along.y, along.x);
    });
  return leaving;
}

Faces trace_faces(const Arrangement& arrangement) {
  const std::vector<std::vector<std::uint32_t>> leaving = leaving_half_edges(arrangement);
  std::vector<std::uint32_t> next(2 * arrangement.edge.size());
  for (const std::vector<std::uint32_t>& halves : leaving)
    for (std::size_t i = 0; i < halves.size(); ++i)  // Arriving against one, leave by the one
      next[halves[i] ^ 1U] = halves[(i + halves.size() - 1) % halves.size()];  // clockwise of it.

  Faces faces;
  faces.face_of.assign(next.size(), no_face);
  std::vector<bool> walked(next.size(), false);
  std::vector<std::vector<std::uint32_t>> holes;
  for (std::uint32_t start = 0; start < next.size(); ++start) {
    if (walked[start]) continue;
    std::vector<std::uint32_t> cycle;
    for (std::uint32_t half = start; !walked[half]; half = next[half]) {
      walked[half] = true;
      cycle.push_back(half);
    }
    const double area = cycle_area(arrangement, cycle);
    if (area <= 1e-9) {  // The way round a tree has none, but for rounding.
      holes.push_back(std::move(cycle));
      continue;
    }
    for (const std::uint32_t half : cycle)
      faces.face_of[half] = static_cast<std::uint32_t>(faces.face.size());
    faces.face.push_back({std::move(cycle), {}, area});
  }
  place_holes(arrangement, faces, holes);
  return faces;
}

std::vector<Vec2> corners_of(const Arrangement& arrangement, std::span<const std::uint32_t> cycle) {
  const std::vector<Vec2> ring = ring_of(arrangement, cycle);
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 before =
        corners.empty() ? ring[(i + ring.size() - 1) % ring.size()] : corners.back();
    const Vec2 after = ring[(i + 1) % ring.size()];
    if (before == ring[i]) continue;
    const bool straight = distance_to_segment(ring[i], before, after) < 0.002 &&
                          dot(ring[i] - before, after - ring[i]) > 0;
    if (!straight) corners.push_back(ring[i]);
  }
  return corners.size() >= 3 ? corners : ring;
}

}  // namespace docent::import
