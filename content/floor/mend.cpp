#include "content/floor/mend.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "content/content_error.h"
#include "content/floor/corners_on_sides.h"
#include "content/floor/crossings.h"
#include "content/floor/ring_overlay.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"
#include "runtime/model/none.h"

namespace docent::floor {
namespace {

/// Corners closer than this are one corner. A hair under 1 mm, because two coordinates that are
/// written 1 mm apart are that only to within a rounding error.
constexpr double same_corner = 0.999e-3;
/// A side that comes back within this distance of itself is a spike.
constexpr double spike_width = 1e-4;
/// Nobody can stand on a piece of floor of less than a hand's size, in square metres.
constexpr double smallest_floor = 0.01;
constexpr double smallest_plan = 0.5;  ///< Metres.
constexpr double largest_plan = 1e5;   ///< Metres.
/// A million are overlaid in minutes, and a plan that is one has a few a side.
constexpr double most_crossings = 1e6;

/// A ring on its way to becoming walls.
struct DrawnRing {
  OverlayRing ring;
  std::vector<import::SourcePlace> place;  ///< One per vertex.
  bool doorway = false;                    ///< Overlaps on purpose.
};

/// Writes the warnings.
class Reporter {
 public:
  Reporter(const std::vector<std::string>& files, std::vector<Diagnostic>& mendings)
      : files_(files), mendings_(mendings) {}

  void warn(
      const import::SourcePlace& place, std::string code, std::string message,
      std::string hint = "nothing need be done if that is meant; else draw it otherwise") const {
    mendings_.push_back({.file = place.file < files_.size() ? files_[place.file] : "",
                         .line = place.line,
                         .column = place.column,
                         .severity = Severity::Warning,
                         .code = std::move(code),
                         .message = std::move(message),
                         .hint = std::move(hint)});
  }

 private:
  const std::vector<std::string>& files_;
  std::vector<Diagnostic>& mendings_;
};

std::string written(Vec2 p) {
  return fmt::format("[{:.3f}, {:.3f}]", p.x, p.y);
}

const char* name_of(const OverlayRing& ring) {
  return ring.hole ? "hole" : "outline";
}

/// Finds for each point the first earlier one that is the same corner. Points lie in the cells of
/// a grid as wide as a corner is large, so only nine cells can hold it.
class Corners {
 public:
  Vec2 unify(Vec2 point) {
    const auto column = static_cast<std::int64_t>(std::floor(point.x / same_corner));
    const auto row = static_cast<std::int64_t>(std::floor(point.y / same_corner));
    const Corner* first = nullptr;
    for (std::int64_t c = column - 1; c <= column + 1; ++c)
      for (std::int64_t r = row - 1; r <= row + 1; ++r)
        if (const auto cell = cells_.find(key(c, r)); cell != cells_.end())
          for (const Corner& corner : cell->second)
            if (glm::distance(corner.point, point) < same_corner &&
                (first == nullptr || corner.rank < first->rank))
              first = &corner;
    if (first != nullptr) return first->point;
    cells_[key(column, row)].push_back({count_++, point});
    return point;
  }

 private:
  struct Corner {
    std::size_t rank;
    Vec2 point;
  };
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    // Cells that share a key only cost a comparison.
    return static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15ULL ^
           static_cast<std::uint64_t>(row);
  }
  std::size_t count_ = 0;
  std::unordered_map<std::uint64_t, std::vector<Corner>> cells_;  // Only looked up, never listed.
};

void erase_vertex(DrawnRing& drawn, std::size_t i) {
  drawn.ring.vertex.erase(drawn.ring.vertex.begin() + static_cast<std::ptrdiff_t>(i));
  if (!drawn.place.empty()) drawn.place.erase(drawn.place.begin() + static_cast<std::ptrdiff_t>(i));
}

import::SourcePlace place_of(const DrawnRing& drawn, std::size_t i) {
  return i < drawn.place.size() ? drawn.place[i] : import::SourcePlace{};
}

void unify_corners(DrawnRing& drawn, Corners& corners, const Reporter* reporter) {
  auto& vertex = drawn.ring.vertex;
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    const Vec2 corner = corners.unify(vertex[i]);
    if (reporter != nullptr && corner != vertex[i])
      reporter->warn(
          place_of(drawn, i), "nearly-coincident-corners",
          fmt::format("this corner of the {} is {:.2g} mm from another, {}, and becomes it",
                      name_of(drawn.ring), 1000 * glm::distance(corner, vertex[i]),
                      written(corner)));
    else if (reporter != nullptr && i > 0 && corner == vertex[i - 1])
      reporter->warn(
          place_of(drawn, i), "repeated-corner",
          fmt::format("this corner of the {} repeats the one before it", name_of(drawn.ring)));
    vertex[i] = corner;
  }
  for (std::size_t i = vertex.size(); i-- > 0;)
    if (vertex.size() > 1 && vertex[i] == vertex[(i + vertex.size() - 1) % vertex.size()])
      erase_vertex(drawn, i);
}

/// Do the sides about `tip` run there and back along one line?
bool is_spike(Vec2 before, Vec2 tip, Vec2 after) {
  if (dot(before - tip, after - tip) <= 0) return false;
  return distance_to_segment(after, before, tip) < spike_width ||
         distance_to_segment(before, tip, after) < spike_width;
}

void remove_spikes(DrawnRing& drawn, const Reporter* reporter) {
  auto& vertex = drawn.ring.vertex;
  std::size_t without_spike = 0;  // This many vertices in a row, going round, were none.
  for (std::size_t i = 0; vertex.size() > 2 && without_spike < vertex.size();) {
    const std::size_t n = vertex.size();
    i %= n;
    const Vec2 before = vertex[(i + n - 1) % n], after = vertex[(i + 1) % n];
    const bool repeats = vertex[i] == before;
    if (!repeats && !is_spike(before, vertex[i], after)) {
      ++i, ++without_spike;
      continue;
    }
    if (reporter != nullptr && !repeats)
      reporter->warn(place_of(drawn, i), "spike",
                     fmt::format("the {} runs to {} and back along one line, which is left out",
                                 name_of(drawn.ring), written(vertex[i])),
                     "a thin wall needs two sides; a doorway needs none");
    erase_vertex(drawn, i);
    without_spike = 0;
    i = i > 1 ? i - 2 : i + n - 3;  // Its neighbours may be spikes now.
  }
}

std::vector<OverlayRing> rings_of(const std::vector<DrawnRing>& drawn) {
  std::vector<OverlayRing> rings;
  rings.reserve(drawn.size());
  for (const DrawnRing& ring : drawn) rings.push_back(ring.ring);
  return rings;
}

/// A side that a corner lies on becomes two, which meet in it.
void split_sides(std::vector<DrawnRing>& drawn) {
  const std::vector<CornerOnSide> found = corners_on_sides(rings_of(drawn));
  for (auto c = found.begin(); c != found.end();) {
    DrawnRing& ring = drawn[c->ring];
    const DrawnRing whole = std::exchange(ring, {{{}, ring.ring.polygon, ring.ring.hole}, {}});
    ring.doorway = whole.doorway;
    const auto add = [&ring, &whole](std::uint32_t side, Vec2 corner) {
      ring.ring.vertex.push_back(corner);
      if (!whole.place.empty()) ring.place.push_back(whole.place[side]);
    };
    const std::uint32_t number = c->ring;
    for (std::uint32_t side = 0; side < whole.ring.vertex.size(); ++side) {
      add(side, whole.ring.vertex[side]);
      for (; c != found.end() && c->ring == number && c->side == side; ++c) add(side, c->corner);
    }
  }
}

/// Vertices unified, spikes gone, corners on sides joined to them; rings of which nothing remains
/// are left out.
std::vector<DrawnRing> tidy(std::vector<DrawnRing> drawn, const Reporter* reporter) {
  Corners corners;
  for (DrawnRing& ring : drawn) {
    const import::SourcePlace start = place_of(ring, 0);
    unify_corners(ring, corners, reporter);
    remove_spikes(ring, reporter);
    if (ring.ring.vertex.size() < 3 && reporter != nullptr)
      reporter->warn(start, "ring-without-area",
                     fmt::format("this {} has no area and is left out", name_of(ring.ring)),
                     "a thin wall needs two sides");
  }
  std::erase_if(drawn, [](const DrawnRing& ring) { return ring.ring.vertex.size() < 3; });
  split_sides(drawn);
  return drawn;
}

std::vector<DrawnRing> collect(const import::ImportedPlan& imported) {
  std::vector<DrawnRing> drawn;
  const auto add = [&](const import::ImportedRing& ring, std::size_t polygon, bool hole) {
    drawn.push_back({{ring.vertex, static_cast<std::uint32_t>(polygon), hole},
                     ring.place,
                     imported.polygons[polygon].doorway});
  };
  for (std::size_t p = 0; p < imported.polygons.size(); ++p) {
    add(imported.polygons[p].outer, p, false);
    for (const import::ImportedRing& hole : imported.polygons[p].holes) add(hole, p, true);
  }
  return drawn;
}

/// A plan of 0.0002 m is one in degrees.
void check_size(const import::ImportedPlan& imported) {
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  for (const import::ImportedPolygon& polygon : imported.polygons)
    for (const Vec2 vertex : polygon.outer.vertex)
      low = glm::min(low, vertex), high = glm::max(high, vertex);
  const double size = std::max(high.x - low.x, high.y - low.y);
  if (size >= smallest_plan && size <= largest_plan) return;
  throw content::ContentError(
      imported.files.empty() ? "" : imported.files.front(), 0, 0, "not-in-metres",
      fmt::format("the whole plan is {:.2g} m large, so its numbers are not metres", size),
      size < smallest_plan ? "if they are longitude and latitude, say --coordinates wgs84"
                           : "convert the plan to metres; --coordinates wgs84 is for degrees only");
}

/// Refuses a plan whose sides cross each other nearly everywhere, as those of a ring do whose
/// points have lost their order: to mend it would take hours.
void check_crossings(const import::ImportedPlan& imported, const std::vector<DrawnRing>& drawn) {
  const Crossings found = estimate_crossings(rings_of(drawn));
  if (found.count <= most_crossings) return;
  const import::SourcePlace place = place_of(drawn[found.ring], found.side);
  throw content::ContentError(
      place.file < imported.files.size() ? imported.files[place.file] : "", place.line,
      place.column, "cannot-mend",
      fmt::format("the outlines of this plan cross at some {:.0f} million places; the side that "
                  "begins here crosses {} others",
                  found.count / 1e6, found.of_that_side),
      "write the points of each ring in their order round it");
}

import::SourcePlace place_near(const DrawnRing& drawn, Vec2 point) {
  const auto nearest = std::ranges::min_element(
      drawn.ring.vertex, {}, [point](Vec2 v) { return glm::distance(v, point); });
  return place_of(drawn, static_cast<std::size_t>(nearest - drawn.ring.vertex.begin()));
}

void report_contact(const RingContact& contact, const std::vector<DrawnRing>& drawn,
                    const Reporter& reporter) {
  const DrawnRing &a = drawn[contact.a], &b = drawn[contact.b];
  if (a.doorway || b.doorway) return;
  const char* meets = contact.crossing ? "crosses" : "touches";
  const import::SourcePlace place = place_near(b, contact.at);
  const std::string at = written(contact.at);
  if (contact.a == contact.b) {
    reporter.warn(place, "ring-crosses-itself",
                  fmt::format("this {} {} itself at {}; all that it encloses counts",
                              name_of(a.ring), meets, at));
  } else if (a.ring.hole && b.ring.hole) {
    reporter.warn(place, "holes-meet",
                  fmt::format("this hole {} another at {}; they become one obstacle", meets, at));
  } else if (a.ring.hole != b.ring.hole) {
    if (a.ring.polygon == b.ring.polygon)
      reporter.warn(
          place, "hole-meets-wall",
          fmt::format("this hole {} the outline at {}; it becomes part of the wall", meets, at));
  } else if (contact.crossing) {  // Areas that share a border are rooms with an open passage.
    reporter.warn(place, "areas-overlap",
                  fmt::format("this area overlaps another at {}; they become one", at));
  }
}

bool is_inside(Vec2 p, std::span<const Vec2> ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

/// Rings that make no wall: holes beyond the outline or within another hole, and areas within
/// another area.
void report_idle_rings(const RingOverlay& walls, const std::vector<DrawnRing>& drawn,
                       const Reporter& reporter) {
  const auto outline = [&](std::uint32_t polygon) {
    return std::ranges::find_if(drawn, [polygon](const DrawnRing& ring) {
      return !ring.ring.hole && ring.ring.polygon == polygon;
    });
  };
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (walls.bounds_any[i] != 0 || !drawn[i].ring.hole) continue;
    const auto outer = outline(drawn[i].ring.polygon);
    const std::vector<Vec2>& hole = drawn[i].ring.vertex;
    if (outer != drawn.end() && is_inside(outer->ring.vertex.front(), hole)) {
      reporter.warn(place_of(drawn[i], 0), "hole-covers-area",
                    "this hole covers all of its area, which is left out with it");
      continue;
    }
    const bool outside = outer != drawn.end() && !is_inside(hole.front(), outer->ring.vertex);
    reporter.warn(place_of(drawn[i], 0), outside ? "hole-outside-floor" : "hole-without-effect",
                  outside ? "this hole lies outside the floor and is left out"
                          : "this hole lies within another hole or outside what is walkable, and "
                            "is left out");
  }
}

/// RFC 7946, 3.1.6: outlines run counter-clockwise, holes clockwise.
void report_orientation(const RingOverlay& walls, const std::vector<DrawnRing>& drawn,
                        const Reporter& reporter) {
  for (std::uint32_t i = 0; i < drawn.size(); ++i) {
    const bool crosses_itself = std::ranges::any_of(
        walls.contacts, [i](const RingContact& c) { return c.a == i && c.b == i; });
    const bool clockwise = signed_area(drawn[i].ring.vertex) < 0;
    if (!crosses_itself && clockwise != drawn[i].ring.hole)
      reporter.warn(place_of(drawn[i], 0), "ring-runs-backwards",
                    fmt::format("this {} runs {}clockwise and is turned round",
                                name_of(drawn[i].ring), clockwise ? "" : "counter-"));
  }
}

void report(const RingOverlay& walls, const std::vector<DrawnRing>& drawn,
            const Reporter& reporter) {
  report_orientation(walls, drawn, reporter);
  for (const RingContact& contact : walls.contacts) report_contact(contact, drawn, reporter);
  report_idle_rings(walls, drawn, reporter);
}

/// Rounding a crossing moves the walls that end there by half a unit in the last place, which may
/// make them cross a third; so the walls are overlaid again until nothing is left to round. Each
/// round moves walls by less than the one before found them apart; two are usual.
std::vector<std::vector<Vec2>> settle(RingOverlay walls, const std::string& file) {
  constexpr int patience = 20;
  for (int round = 0; walls.adds_vertices; ++round) {
    if (round == patience)
      throw content::ContentError(file, 0, 0, "cannot-mend",
                                  "the rings of this plan cross in too many places to be mended",
                                  "draw the outlines so that they do not cross");
    std::vector<DrawnRing> drawn;
    drawn.reserve(walls.walls.size());
    for (std::vector<Vec2>& ring : walls.walls) drawn.push_back({{std::move(ring)}, {}});
    walls = overlay(rings_of(tidy(std::move(drawn), nullptr)), Fill::LeftOfRings);
  }
  return std::move(walls.walls);
}

std::vector<std::vector<Vec2>> find_specks(const std::vector<std::vector<Vec2>>& rings,
                                           const Reporter& reporter) {
  std::vector<std::vector<Vec2>> specks;
  for (const auto& ring : rings)
    if (const double area = signed_area(ring); area > 0 && area < smallest_floor) {
      reporter.warn({}, "speck-of-floor",
                    fmt::format("a piece of floor of {:.2g} cm2 at {} is left out", 1e4 * area,
                                written(ring.front())));
      specks.push_back(ring);
    }
  return specks;
}

/// Drops the pieces of floor that are too small to stand on, with the holes in them.
std::vector<std::vector<Vec2>> drop_specks(std::vector<std::vector<Vec2>> rings,
                                           const Reporter& reporter) {
  const std::vector<std::vector<Vec2>> specks = find_specks(rings, reporter);
  if (specks.empty()) return rings;
  std::vector<DrawnRing> kept;
  for (std::vector<Vec2>& ring : rings) {
    // Rings touch in corners only, so a point in the middle of a wall is on one side or the other.
    const Vec2 middle = (ring[0] + ring[1]) / 2.0;
    const bool belongs_to_speck = std::ranges::any_of(specks, [&](const std::vector<Vec2>& speck) {
      return ring == speck || (signed_area(ring) < 0 && is_inside(middle, speck));
    });
    if (!belongs_to_speck) kept.push_back({{std::move(ring)}, {}});
  }
  // A speck may have touched a wall, which then has a corner there that it needs no more.
  return overlay(rings_of(kept), Fill::LeftOfRings).walls;
}

/// The area of the largest piece within the outlines, whatever stands there; 0 where there is none.
double largest_piece(std::vector<DrawnRing> drawn) {
  std::erase_if(drawn, [](const DrawnRing& ring) { return ring.ring.hole; });
  double largest = 0;
  for (const std::vector<Vec2>& ring : overlay(rings_of(drawn), Fill::Polygons).walls)
    largest = std::max(largest, signed_area(ring));
  return largest;
}

/// Throws what is said of a plan of which nothing is walkable: why.
[[noreturn]] void refuse(const import::ImportedPlan& imported,
                         const std::vector<DrawnRing>& drawn) {
  const std::string file = imported.files.empty() ? "" : imported.files.front();
  const double area = largest_piece(drawn);
  if (area <= 0)
    throw content::ContentError(file, 0, 0, "no-floor",
                                "nothing of this plan is walkable: no outline encloses an area",
                                "draw each outline as a ring about the floor, not as a line there "
                                "and back");
  if (area < smallest_floor)
    throw content::ContentError(
        file, 0, 0, "no-floor",
        fmt::format("nothing of this plan is walkable: its largest piece of floor has {:.2g} cm2",
                    1e4 * area),
        "draw each outline as a ring about the floor; are the numbers metres?");
  throw content::ContentError(file, 0, 0, "no-floor",
                              "nothing of this plan is walkable: its holes cover its areas",
                              "are floor and obstacles swapped?");
}

FloorPlan to_floor_plan(const std::vector<std::vector<Vec2>>& rings) {
  FloorPlan plan;
  for (const std::vector<Vec2>& ring : rings) {
    const auto first = static_cast<std::uint32_t>(plan.vertex.size());
    const auto count = static_cast<std::uint32_t>(ring.size());
    plan.ring.push_back({first, count});
    for (std::uint32_t i = 0; i < count; ++i) plan.next.push_back(first + (i + 1) % count);
    plan.vertex.insert(plan.vertex.end(), ring.begin(), ring.end());
  }
  return plan;
}

}  // namespace

FloorPlan mend(const import::ImportedPlan& imported, std::vector<Diagnostic>& mendings) {
  const Reporter reporter(imported.files, mendings);
  check_size(imported);

  std::vector<DrawnRing> collected = collect(imported);
  check_crossings(imported, collected);
  const std::vector<DrawnRing> drawn = tidy(std::move(collected), &reporter);
  RingOverlay walls = overlay(rings_of(drawn), Fill::Polygons);
  report(walls, drawn, reporter);
  const std::vector<std::vector<Vec2>> rings = drop_specks(
      settle(std::move(walls), imported.files.empty() ? "" : imported.files.front()), reporter);
  if (rings.empty()) refuse(imported, drawn);
  return to_floor_plan(rings);
}

FloorPlan plan_of_walls(std::vector<OverlayRing> rings) {
  std::vector<DrawnRing> drawn;
  for (OverlayRing& ring : rings) drawn.push_back({std::move(ring), {}});
  const std::vector<std::string> no_files;
  std::vector<Diagnostic> unsaid;
  const Reporter reporter(no_files, unsaid);
  const std::vector<std::vector<Vec2>> walls = drop_specks(
      settle(overlay(rings_of(tidy(std::move(drawn), nullptr)), Fill::LeftOfRings), ""), reporter);
  if (walls.empty())
    throw content::ContentError("", 0, 0, "no-floor", "nothing of this plan is walkable");
  return to_floor_plan(walls);
}

}  // namespace docent::floor
