#include "content/compile/compile_rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "content/compile/compile_exhibits.h"
#include "content/compile/place_exhibits.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::compile {

namespace {

class RoomCompiler {
 public:
  RoomCompiler(const config::MuseumConfig& config,
               std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
               Report& report)
      : config_(config), maps_(maps), museum_(museum), report_(report) {}

  void add_all() {
    for (const config::RoomSection& section : config_.rooms) {
      Room room{
          .id = section.id.value,
          .floor = static_cast<std::uint32_t>(config::floor_index(config_, section.floor.value)),
          .title = plain_texts(section.title.value),
          .label = section.label.value,
          .outline = section.outline.value,
          .closed = section.closed.value,
          .hours = section.hours.value};
      if (section.outline.given) check_outline(section, room);
      if (signed_area(room.outline) < 0) std::ranges::reverse(room.outline);
      check_room_place(section, room);
      museum_.rooms.push_back(std::move(room));
    }
  }

 private:
  void check_outline(const config::RoomSection& section, const Room& room) {
    if (const auto crossing = crossing_of(room.outline))
      return error(section.outline.place, "bad-value",
                   fmt::format("the outline of room '{}' crosses itself at {}", room.id,
                               point_text(*crossing)),
                   {}, "write its corners in the order in which one walks round the room");
    if (room.outline.size() < 3 || signed_area(room.outline) == 0)
      error(section.outline.place, "bad-value",
            fmt::format("the outline of room '{}' holds no area", room.id), {},
            "write three corners or more: [[east, north], ...]");
  }

  /// Where two sides of an outline cross that have no corner in common.
  static std::optional<Vec2> crossing_of(const std::vector<Vec2>& outline) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i + 2 < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j) {
        const Vec2 a = outline[i], b = outline[i + 1], c = outline[j], d = outline[(j + 1) % n];
        const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
        const double c_side = side(a, b, c), d_side = side(a, b, d);
        if (c_side * d_side < 0 && side(c, d, a) * side(c, d, b) < 0)
          return c + c_side / (c_side - d_side) * (d - c);
      }
    return {};
  }

  void error(const config::Place& place, std::string code, std::string message,
             std::string label = {}, std::string hint = {}) {
    report_.add(config::diagnostic_at(config_, place, std::move(code), std::move(message),
                                      std::move(label), std::move(hint)));
  }

  void warning(const config::Place& place, std::string code, std::string message,
               std::string label = {}, std::string hint = {}) {
    Diagnostic diagnostic = config::diagnostic_at(
        config_, place, std::move(code), std::move(message), std::move(label), std::move(hint));
    diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  /// Does a room lie where the plan has floor?
  void check_room_place(const config::RoomSection& section, const Room& room) {
    if (room.floor >= maps_.size() || !maps_[room.floor]) return;
    const path::FloorMap& map = *maps_[room.floor];
    const std::string& floor = config_.floors[room.floor].name.value;
    const double share = share_on_floor(map, room.outline);
    if (share == 0)
      return error(section.outline.place, "room-outside-floor",
                   fmt::format("the outline of room '{}' lies elsewhere: no part of it is on floor "
                               "'{}'",
                               room.id, floor),
                   {}, "write its corners as they are on the plan: [[east, north], ...] in metres");
    if (share < 0.25)
      warning(section.outline.place, "room-outside-floor",
              fmt::format("only {:.0f} % of the outline of room '{}' is on floor '{}'", 100 * share,
                          room.id, floor),
              {}, "is it the right room, and in metres?");
    if (section.label.given && !map.is_inside(room.label))
      warning(section.label.place, "label-outside-floor",
              fmt::format("the name of room '{}' would stand outside floor '{}'", room.id, floor),
              fmt::format("{:.2f} m outside", map.clearance_at(room.label)), label_hint(map, room));
    else if (section.label.given && room.outline.size() > 2 && !contains(room.outline, room.label))
      warning(section.label.place, "label-outside-room",
              fmt::format("the name of room '{}' would stand outside its outline", room.id), {},
              label_hint(map, room));
  }

  /// A place for a room's name: the most open one of its outline, by a grid of points.
  static std::string label_hint(const path::FloorMap& map, const Room& room) {
    std::optional<Vec2> best;
    double clearance = 0;
    const auto consider = [&](Vec2 p) {
      if (!map.is_inside(p) || map.clearance_at(p) <= clearance) return;
      clearance = map.clearance_at(p);
      best = p;
    };
    for_grid(room.outline, consider);
    if (!best) best = nearest_free_point(map, room.label, 0);
    return best ? fmt::format("write label = {}", point_text(*best))
                : "write where the name should stand on the plan: [east, north]";
  }

  /// Calls `visit` for the points of a grid that lie in an outline.
  template <typename Visit>
  static void for_grid(const std::vector<Vec2>& outline, const Visit& visit) {
    if (outline.size() < 3) return;
    Vec2 low = outline.front(), high = outline.front();
    for (const Vec2 p : outline) low = glm::min(low, p), high = glm::max(high, p);
    constexpr int points = 24;
    for (int row = 0; row < points; ++row)
      for (int column = 0; column < points; ++column) {
        const Vec2 p = low + (Vec2{column + 0.5, row + 0.5} / double{points}) * (high - low);
        if (contains(outline, p)) visit(p);
      }
  }

  /// How much of an outline is floor, by a grid of points; 1 where there is no outline.
  static double share_on_floor(const path::FloorMap& map, const std::vector<Vec2>& outline) {
    int inside = 0, walkable = 0;
    for_grid(outline, [&](Vec2 p) {
      ++inside;
      walkable += map.is_inside(p) ? 1 : 0;
    });
    return inside == 0 ? 1 : static_cast<double>(walkable) / inside;
  }

  const config::MuseumConfig& config_;
  std::span<const std::shared_ptr<const path::FloorMap>> maps_;
  Museum& museum_;
  Report& report_;
};

}  // namespace

void compile_rooms(const config::MuseumConfig& config,
                   std::span<const std::shared_ptr<const path::FloorMap>> maps, Museum& museum,
                   Report& report) {
  RoomCompiler(config, maps, museum, report).add_all();
}

}  // namespace docent::compile
