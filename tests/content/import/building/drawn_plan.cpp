#include "tests/content/import/building/drawn_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "content/import/building/lay_out.h"
#include "runtime/model/geometry/segment.h"

namespace docent::test {
namespace {

using import::BuildingRing;
using import::ImportedLevel;
using import::ImportedRoom;
using import::Shape;

constexpr double outer_wall = 0.3, widest_door = 1.8;  // Metres.
constexpr double pi = std::numbers::pi;

BuildingRing box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Shape largest_part(const Shape& shape) {
  const auto parts = import::polygons_of(shape);
  return parts.empty() ? Shape() : import::shape_of(parts.front());
}

}  // namespace

KnownFloor known_floor(const ImportedLevel& drawn, double wall_thickness) {
  ImportedLevel level = drawn;
  const double less = (wall_thickness - import::partition) / 2;
  for (ImportedRoom& room : level.rooms) {
    room.kind = "room";
    const Shape shape = largest_part(import::grown(import::shape_of(room.rings), -less));
    room.rings = shape.empty() ? std::vector<BuildingRing>{} : import::polygons_of(shape).front();
  }
  std::erase_if(level.rooms, [](const ImportedRoom& room) { return room.rings.empty(); });
  level.ways.clear();
  for (import::ImportedDoor& door : level.doors)  // What is wider has no wall at all.
    if (const double width = glm::distance(door.a, door.b); width > widest_door) {
      const Vec2 middle = (door.a + door.b) / 2.0,
                 half = (door.b - door.a) * (widest_door / width / 2);
      door.a = middle - half;
      door.b = middle + half;
    }
  std::vector<import::Doubt> doubts;
  const import::LaidLevel laid = import::lay_out(level, doubts);

  KnownFloor floor;
  std::vector<Shape> all;
  for (const ImportedRoom& room : level.rooms) {
    all.push_back(import::shape_of(room.rings));
    std::vector<Shape> smaller;
    for (const ImportedRoom& other : level.rooms)
      if (&other != &room && import::shape_of(other.rings).area() < all.back().area())
        smaller.push_back(import::shape_of(other.rings));
    Shape own = import::common(
        import::grown(import::without(all.back(), import::united(smaller)), -import::partition / 2),
        laid.floor);
    own = largest_part(own);
    if (own.area() < 1.2 || import::grown(own, -0.45).empty()) continue;
    floor.rooms.push_back({room.name, std::move(own)});
  }
  for (const import::LaidDoor& door : laid.doors)
    floor.doors.push_back({door.a, door.b, wall_thickness});
  const Shape mass = import::grown(import::grown(import::united(all), outer_wall + wall_thickness),
                                   -wall_thickness);
  floor.walls = import::polygons_of(import::without(mass, laid.floor));
  return floor;
}

ImportedLevel random_level(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::round((low + (high - low) * static_cast<double>(random()) / 4294967296.0) * 20) /
           20;
  };
  ImportedLevel level{.name = "0"};
  const double width = between(24, 60), corridor = between(1.6, 3), south = between(4, 8),
               north = between(4, 9);
  const double y0 = south, y1 = south + corridor, y2 = y1 + north;
  int number = 100;
  const auto add = [&](BuildingRing ring) {
    level.rooms.push_back({.name = fmt::format("Room {}", ++number), .rings = {std::move(ring)}});
  };
  const auto door = [&](Vec2 at, bool along_x) {
    const double half = (random() % 6 == 0 ? 1.6 : between(0.8, 1.1)) / 2;
    const Vec2 along = along_x ? Vec2{half, 0} : Vec2{0, half};
    level.doors.push_back({.a = at - along, .b = at + along, .width = 2 * half});
  };
  add(box(0, y0, width, y1));
  for (const bool upper : {false, true}) {
    bool whole_before = false;  // Is the room before one, so that a door to it meets no wall?
    for (double x = 0; x < width - 0.1;) {
      double next = x + between(2.6, 7);
      if (width - next < 2.6) next = width;
      const double low = upper ? y1 : 0, high = upper ? y2 : y0;
      const bool parted = random() % 4 == 0 && high - low > 5.5;
      door({between(x + 1.2, next - 1.2), upper ? y1 : y0}, true);
      if (!parted && whole_before && random() % 3 == 0) door({x, (low + high) / 2}, false);
      whole_before = !parted;
      if (parted) {  // A room behind the room.
        const double part = between(low + 2.4, high - 2.4);
        add(box(x, low, next, part));
        add(box(x, part, next, high));
        door({between(x + 1.2, next - 1.2), part}, true);
      } else {
        add(box(x, low, next, high));
      }
      x = next;
    }
  }
  // A hall at the end.
  const double deep = between(8, 14);
  add({{width, -2}, {width + deep, -2}, {width + deep, y2 + 2}, {width, y2 + 2}});
  door({width, (y0 + y1) / 2}, false);
  return level;
}

ImportedLevel curved_level(std::uint32_t seed) {
  ImportedLevel level = random_level(seed);
  double width = 0;
  for (const ImportedRoom& room : level.rooms)
    for (const Vec2 p : room.rings.front()) width = std::max(width, p.x);
  // A rotunda behind the hall, and columns in the hall.
  const double high = level.rooms.back().rings.front()[2].y,
               low = level.rooms.back().rings.front()[0].y;
  const Vec2 centre{width + 5.8, (low + high) / 2};
  BuildingRing round;
  for (int i = 0; i < 72; ++i)
    round.push_back(centre + 6.0 * Vec2{std::cos(i * pi / 36), std::sin(i * pi / 36)});
  const Shape disc = import::without(import::shape_of({{round}}),
                                     import::shape_of({{level.rooms.back().rings.front()}}));
  level.rooms.push_back({.name = "Rotunda", .rings = import::polygons_of(disc).front()});
  level.doors.push_back({.a = {width, centre.y - 0.5}, .b = {width, centre.y + 0.5}, .width = 1});
  for (const double share : {0.3, 0.7}) {
    const Vec2 at{width - 4, low + share * (high - low)};
    level.obstacles.push_back(box(at.x - 0.2, at.y - 0.2, at.x + 0.2, at.y + 0.2));
  }
  // A wing of slanted walls below the hall.
  const double x = width - 8;
  level.rooms.push_back(
      {.name = "Slant 1", .rings = {{{x, low - 6}, {x + 4, low - 7}, {x + 4.6, low}, {x, low}}}});
  level.rooms.push_back(
      {.name = "Slant 2",
       .rings = {{{x + 4, low - 7}, {x + 8, low - 8}, {x + 8, low}, {x + 4.6, low}}}});
  level.doors.push_back({.a = {x + 1.5, low}, .b = {x + 2.5, low}, .width = 1});
  level.doors.push_back({.a = {x + 6, low}, .b = {x + 7, low}, .width = 1});
  return level;
}

Vec2 drawn_at(Vec2 p, const DrawingManner& manner) {
  if (manner.mirror) p.x = -p.x;
  const double c = std::cos(manner.turn), s = std::sin(manner.turn);
  return Vec2{c * p.x - s * p.y, s * p.x + c * p.y} + manner.move;
}

namespace {

/// Writes entities in the drawing's unit.
class DxfWriter {
 public:
  explicit DxfWriter(const DrawingManner& manner) : manner_(manner), random_(7) {}

  std::string text(const std::vector<KnownFloor>& floors) && {
    double offset = 0;
    for (const KnownFloor& floor : floors) {
      shift_ = {offset, 0};
      draw(floor);
      offset += width_of(floor) + 12;
    }
    static const std::map<double, int> units = {
        {0.0254, 1}, {0.3048, 2}, {0.001, 4}, {0.01, 5}, {1, 6}};
    const auto unit = units.find(manner_.metres_per_unit);
    std::string out = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1027\n";
    if (manner_.states_unit && unit != units.end())
      out += fmt::format("9\n$INSUNITS\n70\n{}\n", unit->second);
    out += "0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" + blocks_ + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" +
           entities_ + "0\nENDSEC\n0\nEOF\n";
    return out;
  }

 private:
  static double width_of(const KnownFloor& floor) {
    double low = 1e9, high = -1e9;
    for (const auto& polygon : floor.walls)
      for (const Vec2 p : polygon.front()) {
        low = std::min({low, p.x, p.y});
        high = std::max({high, p.x, p.y});
      }
    return high - low;
  }

  [[nodiscard]] Vec2 place(Vec2 p) const {
    return drawn_at(p + shift_, manner_) / manner_.metres_per_unit;
  }
  double off(double most) {
    return most * (2.0 * static_cast<double>(random_()) / 4294967296.0 - 1);
  }

  void put(std::string entity) {
    for (int i = 0; i < manner_.copies; ++i) entities_ += entity;
  }
  void line(Vec2 a, Vec2 b, const std::string& layer) {
    const Vec2 p = place(a), q = place(b);
    put(fmt::format("0\nLINE\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n11\n{:.6f}\n21\n{:.6f}\n", layer, p.x,
                    p.y, q.x, q.y));
  }
  void polyline(const std::vector<Vec2>& points, bool closed, const std::string& layer,
                const std::vector<double>& bulges = {}) {
    std::string text =
        fmt::format("0\nLWPOLYLINE\n100\nAcDbEntity\n8\n{}\n100\nAcDbPolyline\n90\n{}\n70\n{}\n",
                    layer, points.size(), closed ? 1 : 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = place(points[i]);
      text += fmt::format("10\n{:.6f}\n20\n{:.6f}\n", p.x, p.y);
      if (i < bulges.size())
        text += fmt::format("42\n{:.8f}\n", manner_.mirror ? -bulges[i] : bulges[i]);
    }
    put(std::move(text));
  }
  void circle(Vec2 centre, double radius, const std::string& layer) {
    const Vec2 p = place(centre);
    put(fmt::format("0\nCIRCLE\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n40\n{:.6f}\n", layer, p.x, p.y,
                    radius / manner_.metres_per_unit));
  }
  void arc(Vec2 centre, Vec2 from, Vec2 to, const std::string& layer) {  // The shorter way.
    const Vec2 c = place(centre);
    Vec2 a = place(from) - c, b = place(to) - c;
    if (cross(a, b) < 0) std::swap(a, b);
    put(fmt::format("0\nARC\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n40\n{:.6f}\n50\n{:.6f}\n51\n{:.6f}\n",
                    layer, c.x, c.y, glm::length(a), std::atan2(a.y, a.x) * 180 / pi,
                    std::atan2(b.y, b.x) * 180 / pi));
  }

  void draw(const KnownFloor& floor) {
    for (const auto& polygon : floor.walls)
      for (const BuildingRing& ring : polygon) draw_wall(ring);
    for (std::size_t i = 0; i < floor.doors.size(); ++i) draw_door(floor.doors[i], i);
    for (std::size_t i = 0; i < floor.rooms.size(); ++i) draw_contents(floor.rooms[i], i);
    if (manner_.hatch != Hatch::None)
      for (const auto& polygon : floor.walls) draw_hatch(polygon);
    if (manner_.dimensions || manner_.axes) draw_dimensions(floor);
  }

  void draw_wall(const BuildingRing& ring) {
    if (manner_.polylines) {
      polyline(ring, true, manner_.wall_layer);
      return;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double length = glm::distance(a, b);
      const Vec2 along = (b - a) / length;
      const double more = length > 0.5 ? manner_.overshoot - manner_.gap : 0;
      a += -more / 2 * along + off(manner_.crooked) * left_of(along);
      b += more / 2 * along + off(manner_.crooked) * left_of(along);
      const int pieces = manner_.in_pieces ? std::max(1, static_cast<int>(length / 0.4)) : 1;
      for (int k = 0; k < pieces; ++k)
        line(glm::mix(a, b, static_cast<double>(k) / pieces), glm::mix(a, b, (k + 1.0) / pieces),
             manner_.wall_layer);
    }
  }

  void draw_door(const KnownFloor::Door& door, std::size_t index) {
    const double width = glm::distance(door.a, door.b);
    const Vec2 along = (door.b - door.a) / width;
    const Vec2 across = (index % 2 == 0 ? 1.0 : -1.0) * left_of(along);
    const Vec2 face = door.thickness / 2 * across;  // The leaf hangs at the wall's face.
    const Vec2 a = door.a + face, b = door.b + face;
    if (manner_.doors == DoorsDrawn::Gaps) return;
    if (manner_.doors == DoorsDrawn::Sliding) {
      const Vec2 begin = a + 0.02 * across, end = begin - width * along;
      return polyline({begin, end, end + 0.04 * across, begin + 0.04 * across}, true,
                      manner_.door_layer);
    }
    if (manner_.doors == DoorsDrawn::Thresholds) {
      line(a, b, manner_.door_layer);
      return line(door.a - face, door.b - face, manner_.door_layer);
    }
    // A wide door has two leaves.
    if (width < 1.2) return draw_leaf(a, b, across);
    draw_leaf(a, (a + b) / 2.0, across);
    draw_leaf(b, (a + b) / 2.0, across);
  }

  void draw_leaf(Vec2 hinge, Vec2 shut, Vec2 across) {
    const double width = glm::distance(hinge, shut);
    const Vec2 along = (shut - hinge) / width, open = hinge + width * across;
    if (manner_.doors == DoorsDrawn::Blocks) return insert_door(hinge, along, across, width);
    if (manner_.doors == DoorsDrawn::Arcs) {
      line(hinge, open, manner_.door_layer);
      return arc(hinge, shut, open, manner_.door_layer);
    }
    polyline({hinge, open, open + 0.04 * along, hinge + 0.04 * along}, true, manner_.door_layer);
    const double bulge = std::tan(pi / 8) * (cross(along, across) > 0 ? 1 : -1);
    polyline({shut, open}, false, manner_.door_layer, {bulge, 0});
  }

  /// A block of a door one unit wide, hinged at (0, 0), shut along x, open along y.
  void insert_door(Vec2 a, Vec2 along, Vec2 across, double width) {
    if (!door_block_) {
      blocks_ +=
          "0\nBLOCK\n8\n0\n2\nDOOR1\n70\n0\n10\n0\n20\n0\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n0\n21\n1"
          "\n0\nARC\n8\n0\n10\n0\n20\n0\n40\n1\n50\n0\n51\n90\n0\nENDBLK\n";
      door_block_ = true;
    }
    const Vec2 p = place(a), x = place(a + along) - p, y = place(a + across) - p;
    const double turn = std::atan2(x.y, x.x) * 180 / pi;
    const double scale = width / manner_.metres_per_unit;
    put(
        fmt::format("0\nINSERT\n8\n{}\n2\nDOOR1\n10\n{:.6f}\n20\n{:.6f}\n41\n{:.6f}\n42\n{:.6f}"
                    "\n43\n1\n50\n{:.6f}\n",
                    manner_.door_layer, p.x, p.y, scale, cross(x, y) > 0 ? scale : -scale, turn));
  }

  void draw_contents(const KnownFloor::Room& room, std::size_t index) {
    const Vec2 middle = import::middle_of(room.shape);
    if (manner_.texts) write(room.name, middle, index);
    if (manner_.furniture == Furniture::None) return;
    const Shape free = import::grown(room.shape, -1.3);
    if (free.empty()) return;
    const Vec2 at = import::middle_of(free) + Vec2{0.2, -0.5};
    const std::vector<std::pair<Vec2, Vec2>> boxes = {{{-0.8, -0.4}, {0.8, 0.4}},
                                                      {{-0.25, 0.45}, {0.25, 0.95}}};
    if (manner_.furniture == Furniture::Lines) {
      for (const auto& [low, high] : boxes) {
        const BuildingRing ring = box(at.x + low.x, at.y + low.y, at.x + high.x, at.y + high.y);
        for (std::size_t i = 0; i < 4; ++i)
          line(ring[i], ring[(i + 1) % 4], manner_.furniture_layer);
      }
      circle(at + Vec2{-0.5, 0.75}, 0.2, manner_.furniture_layer);
      // A cupboard along a wall: from the room's edge.
      return;
    }
    if (!desk_block_) {
      blocks_ += "0\nBLOCK\n8\n0\n2\nDESK\n70\n0\n10\n0\n20\n0\n";
      for (const auto& [low, high] : boxes)
        blocks_ += fmt::format(
            "0\nLWPOLYLINE\n100\nAcDbEntity\n8\n0\n100\nAcDbPolyline\n90\n4\n70\n1\n10\n{}\n20\n{}"
            "\n10\n{}\n20\n{}\n10\n{}\n20\n{}\n10\n{}\n20\n{}\n",
            low.x, low.y, high.x, low.y, high.x, high.y, low.x, high.y);
      blocks_ += "0\nENDBLK\n";
      desk_block_ = true;
    }
    const Vec2 p = place(at);
    const double scale = 1 / manner_.metres_per_unit;
    put(fmt::format(
        "0\nINSERT\n8\n{}\n2\nDESK\n10\n{:.6f}\n20\n{:.6f}\n41\n{:.6f}\n42\n{:.6f}\n50\n{:.6f}\n",
        manner_.furniture_layer, p.x, p.y, scale, scale, manner_.turn * 180 / pi + 15));
  }

  void write(const std::string& name, Vec2 at, std::size_t index) {
    const Vec2 p = place(at);
    const double height = 0.2 / manner_.metres_per_unit;
    if (!manner_.texts_are_attributes) {
      entities_ += fmt::format(
          "0\nTEXT\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n11\n{:.6f}\n21\n{:.6f}\n40\n{:.6f}"
          "\n72\n1\n73\n2\n1\n{}\n",
          manner_.text_layer, p.x, p.y, p.x, p.y, height, name);
      return;
    }
    if (!tag_block_) {
      blocks_ +=
          "0\nBLOCK\n8\n0\n2\nTAG\n70\n2\n10\n0\n20\n0\n0\nATTDEF\n8\n0\n10\n0\n20\n0\n40\n1\n1\nNA"
          "ME\n2\nNAME\n0\nENDBLK\n";
      tag_block_ = true;
    }
    entities_ += fmt::format(
        "0\nINSERT\n8\n{0}\n66\n1\n2\nTAG\n10\n{1:.6f}\n20\n{2:.6f}\n0\nATTRIB\n8\n{0}\n10\n{1:.6f}"
        "\n20\n{2:.6f}\n40\n{3:.6f}\n1\n{4}\n2\nNAME\n70\n0\n72\n1\n11\n{1:.6f}\n21\n{2:.6f}\n"
        "0\nATTRIB\n8\n{0}\n10\n{1:.6f}\n20\n{2:.6f}\n40\n{3:.6f}\n1\nID-{5}"
        "\n2\nID\n70\n1\n0\nSEQEND\n8\n{0}\n",
        manner_.text_layer, p.x, p.y, height, name, index);
  }

  void draw_hatch(const std::vector<BuildingRing>& polygon) {
    if (manner_.hatch == Hatch::Entities) {
      entities_ += fmt::format(
          "0\nHATCH\n8\n{}\n10\n0\n20\n0\n30\n0\n2\nSOLID\n70\n1\n91\n1\n92\n1\n93\n{}\n",
          manner_.hatch_layer, polygon.front().size());
      return;
    }
    // Slanted strokes from face to face of thick walls.
    const Shape wall = import::shape_of(polygon);
    const import::Box bounds = wall.bounds();
    for (double x = bounds.low.x - (bounds.high.y - bounds.low.y); x < bounds.high.x; x += 0.5) {
      const Vec2 stroke[] = {{x, bounds.low.y}, {x + bounds.high.y - bounds.low.y, bounds.high.y}};
      const Shape cut =
          import::common(import::shape_about(stroke, 1e-4, import::LineEnds::Flat), wall);
      for (const auto& piece : import::polygons_of(cut)) {
        const auto [low, high] =
            std::ranges::minmax_element(piece.front(), {}, [](Vec2 p) { return p.x; });
        if (glm::distance(*low, *high) > 0.02) line(*low, *high, manner_.hatch_layer);
      }
    }
  }

  void draw_dimensions(const KnownFloor& floor) {
    Vec2 low{1e9, 1e9}, high{-1e9, -1e9};
    for (const auto& polygon : floor.walls)
      for (const Vec2 p : polygon.front()) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    if (manner_.dimensions) {
      line({low.x, low.y - 1}, {high.x, low.y - 1}, manner_.dimension_layer);
      for (double x = low.x; x <= high.x; x += 4) {
        line({x, low.y - 1.2}, {x, low.y - 0.1}, manner_.dimension_layer);
        line({x - 0.1, low.y - 1.1}, {x + 0.1, low.y - 0.9}, manner_.dimension_layer);
      }
    }
    if (!manner_.axes) return;
    for (double x = low.x + 1.7; x < high.x; x += 6.3) {
      line({x, low.y - 3}, {x, high.y + 3}, manner_.axis_layer);
      circle({x, low.y - 3.4}, 0.4, manner_.axis_layer);
    }
  }

  const DrawingManner& manner_;
  std::mt19937 random_;
  Vec2 shift_{};
  std::string blocks_, entities_;
  bool door_block_ = false, desk_block_ = false, tag_block_ = false;
};

}  // namespace

std::string draw_dxf(const std::vector<KnownFloor>& floors, const DrawingManner& manner) {
  return DxfWriter(manner).text(floors);
}

FoundShare& FoundShare::operator+=(const FoundShare& other) {
  rooms += other.rooms;
  right += other.right;
  extra += other.extra;
  doors += other.doors;
  doors_right += other.doors_right;
  doors_extra += other.doors_extra;
  missed.insert(missed.end(), other.missed.begin(), other.missed.end());
  return *this;
}

FoundShare judge(const KnownFloor& floor, const ImportedLevel& level, const DrawingManner& manner,
                 Vec2 moved_by) {
  FoundShare share{.rooms = floor.rooms.size(), .doors = floor.doors.size()};
  const auto found_at = [&](Vec2 p) { return drawn_at(p, manner) - moved_by; };
  std::vector<Shape> found;
  for (const ImportedRoom& room : level.rooms) found.push_back(import::shape_of(room.rings));
  std::set<std::size_t> used;
  for (const KnownFloor::Room& room : floor.rooms) {
    const Vec2 middle = found_at(import::middle_of(room.shape));
    const double area = room.shape.area();
    // What stands in the room may cover its middle.
    std::size_t nearest = found.size();
    for (std::size_t i = 0; i < found.size(); ++i)
      if (!used.contains(i) &&
          import::holds(import::shape_of({&level.rooms[i].rings.front(), 1}), middle) &&
          (nearest == found.size() ||
           std::abs(found[i].area() - area) < std::abs(found[nearest].area() - area)))
        nearest = i;
    if (nearest < found.size()) used.insert(nearest);
    const double got = nearest < found.size() ? found[nearest].area() : 0;
    const bool right = std::abs(got - area) <= 0.05 * area;
    share.right += right;
    if (!right)
      share.missed.push_back(fmt::format("{} is {:.1f} m2, found {:.1f} at ({:.1f}, {:.1f})",
                                         room.name, area, got, middle.x, middle.y));
  }
  share.extra = found.size() - used.size();
  std::set<std::size_t> met;
  for (const KnownFloor::Door& door : floor.doors) {
    const Vec2 at = found_at((door.a + door.b) / 2.0);
    bool right = false;
    for (std::size_t i = 0; i < level.doors.size(); ++i)
      if (glm::distance((level.doors[i].a + level.doors[i].b) / 2.0, at) < 0.5) {
        met.insert(i);
        right = true;
      }
    share.doors_right += right;
    if (!right) share.missed.push_back(fmt::format("a door at ({:.1f}, {:.1f})", at.x, at.y));
  }
  for (std::size_t i = 0; i < level.doors.size(); ++i)
    if (!met.contains(i)) {
      const Vec2 at = (level.doors[i].a + level.doors[i].b) / 2.0;
      share.missed.push_back(fmt::format("no door at ({:.1f}, {:.1f}), {:.2f} m wide", at.x, at.y,
                                         level.doors[i].width));
    }
  share.doors_extra = level.doors.size() - met.size();
  return share;
}

}  // namespace docent::test
