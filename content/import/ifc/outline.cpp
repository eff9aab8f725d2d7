#include "content/import/ifc/outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "runtime/model/geometry/polygon.h"

namespace docent::import {
namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;
using Kind = StepValue::Kind;

constexpr int deepest_item = 24;
constexpr std::size_t most_points = 20'000;
constexpr double full_turn = 2 * std::numbers::pi;

dvec3 xyz(const StepValue& list) {
  dvec3 out(0);
  for (std::size_t i = 0; i < std::min<std::size_t>(list.items.size(), 3); ++i)
    out[static_cast<int>(i)] = list.items[i].number;
  return out;
}

dvec3 point(const StepFile& step, const StepValue& reference) {
  return xyz(step.at(reference)[0]);
}

dvec3 unit_or(dvec3 v, dvec3 otherwise) {
  const double length = glm::length(v);
  return length > 1e-12 ? v / length : otherwise;
}

/// IfcAxis2Placement3D and 2D: a frame whose z is the axis and whose x is nearest to the reference.
dmat4 axes(const StepFile& step, const StepValue& reference) {
  const StepRecord& record = step.at(reference);
  if (record.type.empty()) return dmat4(1);
  const dvec3 origin = point(step, record[0]);
  dvec3 z(0, 0, 1), x(1, 0, 0);
  if (record.type == "IFCAXIS2PLACEMENT3D") {
    if (record[1].kind == Kind::Reference) z = unit_or(point(step, record[1]), z);
    if (record[2].kind == Kind::Reference) x = unit_or(point(step, record[2]), x);
  } else if (record[1].kind == Kind::Reference) {
    x = unit_or(point(step, record[1]), x);
  }
  x = unit_or(x - glm::dot(x, z) * z,
              std::abs(z.x) < 0.9 ? unit_or(dvec3(1, 0, 0) - z.x * z, x) : dvec3(0, 1, 0));
  const dvec3 y = glm::cross(z, x);
  return dmat4(dvec4(x, 0), dvec4(y, 0), dvec4(z, 0), dvec4(origin, 1));
}

/// IfcCartesianTransformationOperator3D.
dmat4 transformation(const StepFile& step, const StepValue& reference) {
  const StepRecord& record = step.at(reference);
  if (record.type.empty()) return dmat4(1);
  dvec3 x = record[0].kind == Kind::Reference ? unit_or(point(step, record[0]), {1, 0, 0})
                                              : dvec3(1, 0, 0);
  dvec3 z(0, 0, 1);
  if (record.type.find("3D") != std::string::npos && record[4].kind == Kind::Reference)
    z = unit_or(point(step, record[4]), z);
  x = unit_or(x - glm::dot(x, z) * z, {1, 0, 0});
  dvec3 y = glm::cross(z, x);
  if (record[1].kind == Kind::Reference && glm::dot(y, point(step, record[1])) < 0) y = -y;
  const double scale =
      record[3].kind == Kind::Number && record[3].number != 0 ? record[3].number : 1;
  return dmat4(dvec4(scale * x, 0), dvec4(scale * y, 0), dvec4(scale * z, 0),
               dvec4(point(step, record[2]), 1));
}

dvec3 moved(const dmat4& by, dvec3 p) {
  return dvec3(by * dvec4(p, 1));
}

std::vector<dvec3> moved(const dmat4& by, std::vector<dvec3> points) {
  for (dvec3& p : points) p = moved(by, p);
  return points;
}

void add_arc(std::vector<dvec3>& out, const dmat4& frame, double rx, double ry, double from,
             double sweep) {
  const int steps =
      std::clamp(static_cast<int>(std::ceil(std::abs(sweep) / (full_turn / 60))), 1, 60);
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + sweep * i / steps;
    out.push_back(moved(frame, {rx * std::cos(angle), ry * std::sin(angle), 0}));
  }
}

/// An arc through three points.
void add_arc_through(std::vector<dvec3>& out, dvec3 a, dvec3 b, dvec3 c) {
  const Vec2 p(a), q(b), r(c);
  const double d = 2 * cross(q - p, r - p);
  if (std::abs(d) < 1e-12) {
    out.insert(out.end(), {a, b, c});
    return;
  }
  const double qq = dot(q - p, q - p), rr = dot(r - p, r - p);
  const Vec2 centre =
      p + Vec2{(r - p).y * qq - (q - p).y * rr, (q - p).x * rr - (r - p).x * qq} / d;
  const double radius = glm::length(p - centre);
  const auto angle = [&](Vec2 x) { return std::atan2(x.y - centre.y, x.x - centre.x); };
  double sweep = std::fmod(angle(r) - angle(p) + 2 * full_turn, full_turn);
  if (d < 0) sweep -= full_turn;
  add_arc(out,
          dmat4(dvec4(1, 0, 0, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, 1, 0), dvec4(centre, a.z, 1)),
          radius, radius, angle(p), sweep);
}

/// A corner trimmed off a basis curve: its parameter, by a point or a number.
double parameter(const StepFile& step, const StepValue& trims, const dmat4& frame) {
  double out = 0;
  for (const StepValue& trim : trims.items)
    if (trim.kind == Kind::Number) out = trim.number;
  for (const StepValue& trim : trims.items)
    if (trim.kind == Kind::Reference) {
      const dvec3 local = moved(glm::inverse(frame), point(step, trim));
      out = std::atan2(local.y, local.x);
    }
  return out;
}

std::vector<dvec3> curve(const StepFile& step, const StepValue& reference, int depth);

std::vector<dvec3> trimmed_curve(const StepFile& step, const StepRecord& record, int depth) {
  const StepRecord& basis = step.at(record[0]);
  if (basis.type == "IFCCIRCLE" || basis.type == "IFCELLIPSE") {
    const dmat4 frame = axes(step, basis[0]);
    const double rx = basis[1].number, ry = basis.type == "IFCCIRCLE" ? rx : basis[2].number;
    double from = parameter(step, record[1], frame), to = parameter(step, record[2], frame);
    // Degrees or radians: whoever writes angles above a full turn writes degrees.
    if (std::max(std::abs(from), std::abs(to)) > full_turn + 1e-3) {
      from *= full_turn / 360;
      to *= full_turn / 360;
    }
    const bool forward = record[3].text != "F";
    double sweep = std::fmod(forward ? to - from : from - to, full_turn);
    if (sweep <= 1e-9) sweep += full_turn;
    std::vector<dvec3> out;
    add_arc(out, frame, rx, ry, from, forward ? sweep : -sweep);
    return out;
  }
  std::vector<dvec3> ends;
  for (const std::size_t end : {std::size_t{1}, std::size_t{2}})
    for (const StepValue& trim : record[end].items)
      if (trim.kind == Kind::Reference) ends.push_back(point(step, trim));
  if (ends.size() == 2) return ends;
  if (basis.type == "IFCLINE") {
    const StepRecord& vector = step.at(basis[1]);
    const dvec3 origin = point(step, basis[0]), along = point(step, vector[0]) * vector[1].number;
    for (const std::size_t end : {std::size_t{1}, std::size_t{2}})
      if (!record[end].items.empty())
        ends.push_back(origin + record[end].items.front().number * along);
    return ends;
  }
  return curve(step, record[0], depth + 1);
}

std::vector<dvec3> indexed_curve(const StepFile& step, const StepRecord& record) {
  std::vector<dvec3> points, out;
  for (const StepValue& p : step.at(record[0])[0].items) points.push_back(xyz(p));
  const auto at = [&](const StepValue& index) {
    const auto i = static_cast<std::size_t>(std::max(1.0, index.number)) - 1;
    return i < points.size() ? points[i] : dvec3(0);
  };
  if (record[1].items.empty()) return points;
  for (const StepValue& segment : record[1].items) {
    const auto& indices = segment.items;
    if (indices.size() == 3 && points.size() > 2 && segment.text == "IFCARCINDEX")
      add_arc_through(out, at(indices[0]), at(indices[1]), at(indices[2]));
    else
      for (const StepValue& index : indices) out.push_back(at(index));
  }
  return out;
}

std::vector<dvec3> curve(const StepFile& step, const StepValue& reference, int depth) {
  std::vector<dvec3> out;
  if (depth > deepest_item) return out;
  const StepRecord& record = step.at(reference);
  if (record.type == "IFCPOLYLINE" || record.type == "IFCPOLYLOOP") {
    for (const StepValue& p : record[0].items) out.push_back(point(step, p));
  } else if (record.type == "IFCCOMPOSITECURVE" || record.type == "IFC2DCOMPOSITECURVE") {
    for (const StepValue& segment : record[0].items) {
      std::vector<dvec3> part = curve(step, step.at(segment)[2], depth + 1);
      if (step.at(segment)[1].text == "F") std::ranges::reverse(part);
      out.insert(out.end(), part.begin(), part.end());
      if (out.size() > most_points) break;
    }
  } else if (record.type == "IFCTRIMMEDCURVE") {
    out = trimmed_curve(step, record, depth);
  } else if (record.type == "IFCINDEXEDPOLYCURVE") {
    out = indexed_curve(step, record);
  } else if (record.type == "IFCCIRCLE") {
    add_arc(out, axes(step, record[0]), record[1].number, record[1].number, 0, full_turn);
  } else if (record.type == "IFCELLIPSE") {
    add_arc(out, axes(step, record[0]), record[1].number, record[2].number, 0, full_turn);
  }
  return out;
}

using Rings = std::vector<std::vector<dvec3>>;

Rings profile(const StepFile& step, const StepValue& reference) {
  const StepRecord& record = step.at(reference);
  Rings rings;
  if (record.type.starts_with("IFCARBITRARYCLOSEDPROFILEDEF") ||
      record.type.starts_with("IFCARBITRARYPROFILEDEFWITHVOIDS")) {
    rings.push_back(curve(step, record[2], 0));
    for (const StepValue& inner : record[3].items) rings.push_back(curve(step, inner, 0));
  } else if (record.type.find("RECTANGLE") != std::string::npos) {
    const dmat4 frame = axes(step, record[2]);
    const double x = record[3].number / 2, y = record[4].number / 2;
    rings.push_back(moved(frame, {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}}));
  } else if (record.type.find("CIRCLE") != std::string::npos) {
    rings.emplace_back();
    add_arc(rings.back(), axes(step, record[2]), record[3].number, record[3].number, 0, full_turn);
  } else if (record.type.find("ELLIPSE") != std::string::npos) {
    rings.emplace_back();
    add_arc(rings.back(), axes(step, record[2]), record[3].number, record[4].number, 0, full_turn);
  }
  return rings;
}

/// A body as faces, each an outer ring and holes; and rings that are footprints already.
struct Body {
  std::vector<Rings> faces;
  std::vector<Rings> footprints;
  std::size_t points = 0;
  void add(std::vector<Rings>& to, Rings rings) {
    for (const auto& ring : rings) points += ring.size();
    if (points <= most_points && !rings.empty() && rings.front().size() >= 2)
      to.push_back(std::move(rings));
  }
};

void add_extrusion(const StepFile& step, const StepRecord& record, const dmat4& world, Body& body) {
  const dmat4 frame = world * axes(step, record[1]);
  Rings base = profile(step, record[0]);
  if (base.empty()) return;
  const dvec3 along = record[3].number * dvec3(frame * dvec4(point(step, record[2]), 0));
  for (auto& ring : base) ring = moved(frame, std::move(ring));
  const dvec3 up = unit_or(along, {0, 0, 1});
  Rings top = base;
  for (auto& ring : top)
    for (dvec3& p : ring) p += along;
  if (std::abs(up.z) > 0.99) {
    body.add(body.footprints, base);
    body.add(body.faces, std::move(top));
    return;
  }
  for (const auto& ring : base)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const dvec3 a = ring[i], b = ring[(i + 1) % ring.size()];
      body.add(body.faces, {{a, b, b + along, a + along}});
    }
  body.add(body.faces, base);
  body.add(body.faces, std::move(top));
}

void add_shell(const StepFile& step, const StepRecord& shell, const dmat4& world, Body& body) {
  for (const StepValue& reference : shell[0].items) {
    Rings rings;
    for (const StepValue& bound : step.at(reference)[0].items) {
      const StepRecord& record = step.at(bound);
      std::vector<dvec3> ring = moved(world, curve(step, record[0], 0));
      if (record[1].text == "F") std::ranges::reverse(ring);
      if (record.type == "IFCFACEOUTERBOUND")
        rings.insert(rings.begin(), std::move(ring));
      else
        rings.push_back(std::move(ring));
    }
    body.add(body.faces, std::move(rings));
  }
}

void add_indexed_faces(const StepFile& step, const StepRecord& record, const dmat4& world,
                       Body& body) {
  std::vector<dvec3> points;
  for (const StepValue& p : step.at(record[0])[0].items) points.push_back(moved(world, xyz(p)));
  const auto ring_of = [&](const StepValue& list) {
    std::vector<dvec3> ring;
    for (const StepValue& index : list.items)
      if (const auto i = static_cast<std::size_t>(std::max(1.0, index.number)) - 1;
          i < points.size())
        ring.push_back(points[i]);
    return ring;
  };
  if (record.type == "IFCTRIANGULATEDFACESET") {
    for (const StepValue& triangle : record[3].items) body.add(body.faces, {ring_of(triangle)});
    return;
  }
  for (const StepValue& face : record[2].items) {
    Rings rings{ring_of(step.at(face)[0])};
    for (const StepValue& inner : step.at(face)[1].items) rings.push_back(ring_of(inner));
    body.add(body.faces, std::move(rings));
  }
}

void add_item(const StepFile& step, const StepValue& reference, const dmat4& world, Body& body,
              int depth) {
  if (depth > deepest_item || body.points > most_points) return;
  const StepRecord& record = step.at(reference);
  const std::string& type = record.type;
  const auto all_of = [&](const StepValue& list) {
    for (const StepValue& item : list.items) add_item(step, item, world, body, depth + 1);
  };
  if (type == "IFCEXTRUDEDAREASOLID" || type == "IFCEXTRUDEDAREASOLIDTAPERED") {
    add_extrusion(step, record, world, body);
  } else if (type == "IFCBOOLEANCLIPPINGRESULT" || type == "IFCBOOLEANRESULT") {
    add_item(step, record[1], world, body, depth + 1);
  } else if (type.starts_with("IFCFACETEDBREP") || type.starts_with("IFCADVANCEDBREP")) {
    add_shell(step, step.at(record[0]), world, body);
  } else if (type == "IFCFACEBASEDSURFACEMODEL" || type == "IFCSHELLBASEDSURFACEMODEL") {
    for (const StepValue& shell : record[0].items) add_shell(step, step.at(shell), world, body);
  } else if (type == "IFCPOLYGONALFACESET" || type == "IFCTRIANGULATEDFACESET") {
    add_indexed_faces(step, record, world, body);
  } else if (type == "IFCMAPPEDITEM") {
    const StepRecord& map = step.at(record[0]);
    const dmat4 placed = world * transformation(step, record[1]) * axes(step, map[0]);
    for (const StepValue& item : step.at(map[1])[3].items)
      add_item(step, item, placed, body, depth + 1);
  } else if (type == "IFCGEOMETRICCURVESET" || type == "IFCGEOMETRICSET") {
    all_of(record[0]);
  } else if (type == "IFCANNOTATIONFILLAREA") {
    add_item(step, record[0], world, body, depth + 1);
  } else if (type == "IFCBOUNDINGBOX") {
    const dvec3 corner = point(step, record[0]);
    const double x = record[1].number, y = record[2].number, z = record[3].number;
    const Rings base{moved(world, {corner, corner + dvec3(x, 0, 0), corner + dvec3(x, y, 0),
                                   corner + dvec3(0, y, 0)})};
    Rings top = base;
    for (dvec3& p : top.front()) p.z += z;
    body.add(body.faces, base);
    body.add(body.faces, top);
  } else if (type == "IFCCURVEBOUNDEDPLANE") {
    const dmat4 plane = world * axes(step, step.at(record[0])[0]);
    body.add(body.faces, {moved(plane, curve(step, record[1], 0))});
  } else if (type == "IFCSURFACEOFLINEAREXTRUSION") {
    const dmat4 frame = world * axes(step, record[1]);
    const StepRecord& swept = step.at(record[0]);
    std::vector<dvec3> base = moved(
        frame,
        curve(step, swept.type.find("PROFILE") != std::string::npos ? swept[2] : record[0], 0));
    const dvec3 along = record[3].number * dvec3(frame * dvec4(point(step, record[2]), 0));
    std::vector<dvec3> top = base;
    for (dvec3& p : top) p += along;
    body.add(body.faces, {std::move(base)});
    body.add(body.faces, {std::move(top)});
  } else if (type.find("CURVE") != std::string::npos || type == "IFCPOLYLINE") {
    body.add(body.footprints, {moved(world, curve(step, reference, 0))});
  }
}

struct Representation {
  std::string name;  ///< `Body`, `FootPrint`, `Axis`, `Box`.
  Body body;
};

std::vector<Representation> representations(const StepFile& step, const StepValue& shape,
                                            const dmat4& world) {
  std::vector<Representation> out;
  for (const StepValue& reference : step.at(shape)[2].items) {
    const StepRecord& record = step.at(reference);
    Representation representation{record[1].text, {}};
    for (const StepValue& item : record[3].items)
      add_item(step, item, world, representation.body, 0);
    out.push_back(std::move(representation));
  }
  return out;
}

std::vector<Vec2> flat(const std::vector<dvec3>& ring) {
  std::vector<Vec2> out;
  for (const dvec3& p : ring)
    if (out.empty() || glm::length(out.back() - Vec2(p)) > 1e-9) out.emplace_back(p);
  while (out.size() > 1 && glm::length(out.front() - out.back()) < 1e-9) out.pop_back();
  return out;
}

dvec3 normal_of(const std::vector<dvec3>& ring) {
  dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return unit_or(sum, {0, 0, 0});
}

/// The ground of a body by its faces: those that look straight down are taken together, the edges
/// between two of them cancel, and what is left runs around.
std::vector<std::vector<Vec2>> ground_of(const std::vector<Rings>& faces) {
  double low = 1e300, high = -1e300;
  for (const Rings& face : faces)
    for (const dvec3& p : face.front()) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
  using Key = std::pair<long long, long long>;
  std::map<Key, Vec2> places;
  std::multimap<Key, Key> edges;
  const double grain = std::max(1e-9, (high - low) * 1e-4);
  const auto key_of = [&](Vec2 p) {
    const Key key{std::llround(p.x / grain), std::llround(p.y / grain)};
    places.try_emplace(key, p);
    return key;
  };
  for (const Rings& face : faces) {
    if (face.front().size() < 3 || std::abs(normal_of(face.front()).z) < 0.95) continue;
    if (face.front().front().z > low + 0.3 * (high - low)) continue;
    for (const auto& ring3 : face) {
      std::vector<Vec2> ring = flat(ring3);
      if (ring.size() < 3) continue;
      if ((signed_area(ring) < 0) == (&ring3 == &face.front())) std::ranges::reverse(ring);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Key a = key_of(ring[i]), b = key_of(ring[(i + 1) % ring.size()]);
        if (a == b) continue;
        const auto [from, to] = edges.equal_range(b);
        const auto back =
            std::find_if(from, to, [&](const auto& edge) { return edge.second == a; });
        if (back != to)
          edges.erase(back);
        else
          edges.emplace(a, b);
      }
    }
  }
  std::vector<std::vector<Vec2>> rings;
  while (!edges.empty()) {
    std::vector<Vec2> ring;
    const Key start = edges.begin()->first;
    Key at = start;
    do {
      const auto next = edges.find(at);
      if (next == edges.end()) break;
      ring.push_back(places.at(at));
      at = next->second;
      edges.erase(next);
    } while (at != start);
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  std::ranges::stable_sort(rings, std::greater{},
                           [](const auto& ring) { return std::abs(signed_area(ring)); });
  // A second piece apart from the largest is no hole of it.
  if (!rings.empty())
    std::erase_if(rings, [&](const auto& ring) {
      return &ring != &rings.front() && !contains(rings.front(), ring.front());
    });
  return rings;
}

double area_of(const std::vector<std::vector<Vec2>>& rings) {
  double area = 0;
  for (const auto& ring : rings) area += (area == 0 ? 1 : -1) * std::abs(signed_area(ring));
  return area;
}

std::vector<std::vector<Vec2>> outline(const Body& body) {
  std::vector<std::vector<Vec2>> best;
  for (const Rings& footprint : body.footprints) {
    std::vector<std::vector<Vec2>> rings;
    for (const auto& ring : footprint)
      if (std::vector<Vec2> corners = flat(ring); corners.size() >= 3)
        rings.push_back(std::move(corners));
    if (!rings.empty() && area_of(rings) > area_of(best)) best = std::move(rings);
  }
  if (!best.empty()) return best;
  return ground_of(body.faces);
}

}  // namespace

dmat4 placement_of(const StepFile& step, const StepValue& placement) {
  dmat4 world(1);
  std::set<std::uint64_t> seen;  // A placement relative to itself would never end.
  for (const StepValue* at = &placement;
       at->kind == Kind::Reference && seen.insert(at->reference).second;) {
    const StepRecord& record = step.at(*at);
    if (record.type != "IFCLOCALPLACEMENT") break;
    world = axes(step, record[1]) * world;
    at = &record[0];
  }
  return world;
}

std::vector<std::vector<Vec2>> outline_of(const StepFile& step, const StepValue& shape,
                                          const dmat4& world) {
  std::vector<std::vector<Vec2>> best;
  for (const Representation& representation : representations(step, shape, world)) {
    if (representation.name == "Axis" || representation.name == "Box") continue;
    std::vector<std::vector<Vec2>> rings = outline(representation.body);
    if (!rings.empty() && area_of(rings) > 1.02 * area_of(best)) best = std::move(rings);
  }
  return best;
}

std::vector<dvec3> points_of(const StepFile& step, const StepValue& shape, const dmat4& world) {
  std::vector<dvec3> out;
  for (const Representation& representation : representations(step, shape, world)) {
    if (representation.name == "Axis" || representation.name == "Annotation" ||
        representation.name == "FootPrint")
      continue;
    for (const auto* faces : {&representation.body.faces, &representation.body.footprints})
      for (const Rings& face : *faces)
        for (const auto& ring : face) out.insert(out.end(), ring.begin(), ring.end());
  }
  return out;
}

std::vector<dvec3> points_of_item(const StepFile& step, const StepValue& item, const dmat4& world) {
  Body body;
  add_item(step, item, world, body, 0);
  std::vector<dvec3> out;
  for (const auto* faces : {&body.faces, &body.footprints})
    for (const Rings& face : *faces)
      for (const auto& ring : face) out.insert(out.end(), ring.begin(), ring.end());
  return out;
}

}  // namespace docent::import
