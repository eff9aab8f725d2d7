#include "content/import/building/museum_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>

namespace docent::import {
namespace {

/// What a body needs to stand, with a little to spare. Metres.
constexpr double body = 0.3;

/// A text as TOML and JSON write it.
std::string in_quotes(std::string_view text) {
  std::string quote = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      (quote += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      quote += ' ';
    else
      quote += c;
  }
  return quote + '"';
}

/// Metres: three digits after the point are written.
constexpr double written_to = 0.001;

std::string number(double value) {
  std::string text = fmt::format("{:.3f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}
std::string point(Vec2 at) {
  return fmt::format("[{}, {}]", number(at.x), number(at.y));
}
/// A few points a line.
std::string ring_text(const BuildingRing& ring) {
  constexpr std::size_t a_line = 8;
  std::string text = "[";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) text += i % a_line == 0 ? ",\n  " : ", ";
    text += point(ring[i]);
  }
  return text + "]";
}

/// A room's outline as its plan has it. Of one that crosses itself the largest part, on the grid of
/// what is written.
BuildingRing outline_of(const ImportedRoom& room) {
  const BuildingRing& drawn = room.rings.front();
  if (!crosses_itself(drawn)) return drawn;
  const auto parts = polygons_of(on_grid(shape_of({&drawn, 1}), written_to));
  return parts.empty() ? drawn : parts.front().front();
}

/// Letters, digits and hyphens; the letters of western languages lose what is above them.
std::string slug(std::string_view name) {
  constexpr std::string_view plain =
      "aaaaaaaceeeeiiiidnooooo-ouuuuypsaaaaaaaceeeeiiiidnooooo-ouuuuypy";
  std::string id;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    char letter = '-';
    if (c >= 'A' && c <= 'Z')
      letter = static_cast<char>(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      letter = static_cast<char>(c);
    else if (c == 0xc3 && i + 1 < name.size())
      letter = plain[static_cast<unsigned char>(name[++i]) & 0x3fU];
    if (letter != '-' || (!id.empty() && id.back() != '-')) id += letter;
  }
  while (id.ends_with('-')) id.pop_back();
  if (id.size() > 48) id.resize(48);
  while (id.ends_with('-')) id.pop_back();
  return id;
}

/// Gives each thing a name of its own.
class Ids {
 public:
  std::string take(std::string wanted, const std::string& with) {
    if (used_.insert(wanted).second) return wanted;
    if (!with.empty() && used_.insert(wanted + with).second) return wanted + with;
    for (int i = 2;; ++i)
      if (const std::string id = fmt::format("{}-{}", wanted, i); used_.insert(id).second)
        return id;
  }

 private:
  std::set<std::string> used_;
};

std::string ordinal_slug(double ordinal) {
  std::string text = fmt::format("{:g}", std::abs(ordinal));
  std::ranges::replace(text, '.', '-');
  return (ordinal < 0 ? "b" : "") + text;
}

bool is_letter_or_digit(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
}

/// A level and a point on it.
struct StandingPlace {
  std::size_t level = 0;
  Vec2 at{};
};

/// Which parts of a building a body can walk between, over stairs and lifts too.
class WalkableParts {
 public:
  explicit WalkableParts(const LaidBuilding& laid) {
    for (std::size_t level = 0; level < laid.levels.size(); ++level)
      for (const auto& rings : polygons_of(grown(laid.levels[level].floor, -standing)))
        parts_.push_back({level, shape_of(rings), parts_.size()});
    for (const ImportedConnection& connection : laid.building.connections)
      join(laid.building, connection);
    choose();
  }

  /// Where the kiosk is put: in the largest room of its part's lowest level from the ground on.
  [[nodiscard]] std::optional<StandingPlace> kiosk(const ImportedBuilding& building) const {
    const Part* best = nullptr;
    const auto from_ground = [&](const Part& part) {
      return std::abs(building.levels[part.level].ordinal);
    };
    for (const Part& part : parts_) {
      if (root(part.group) != kiosk_group_) continue;
      if (best == nullptr || from_ground(part) < from_ground(*best) ||
          (from_ground(part) == from_ground(*best) && part.shape.area() > best->shape.area()))
        best = &part;
    }
    if (best == nullptr) return {};
    StandingPlace place{best->level, middle_of(best->shape)};
    double largest = 0;
    for (const ImportedRoom& room : building.levels[best->level].rooms) {
      const Shape walkable = common(shape_of(room.rings), best->shape);
      if (walkable.area() <= largest) continue;
      largest = walkable.area();
      place.at = middle_of(walkable);
    }
    return place;
  }

  /// Can one walk from the kiosk to where a body stands?
  [[nodiscard]] bool has_kiosk(std::size_t level, Vec2 at) const {
    const Part* part = part_at(level, at);
    return part != nullptr && root(part->group) == kiosk_group_;
  }

 private:
  static constexpr double standing = 0.27;  ///< A little more than the body's radius. Metres.

  struct Part {
    std::size_t level = 0;
    Shape shape{};
    std::size_t group = 0;
  };

  [[nodiscard]] std::size_t root(std::size_t i) const {
    while (parts_[i].group != i) i = parts_[i].group;
    return i;
  }

  [[nodiscard]] const Part* part_at(std::size_t level, Vec2 at) const {
    for (const Part& part : parts_)
      if (part.level == level && distance(part.shape, at) < 0.01) return &part;
    return nullptr;
  }

  void join(const ImportedBuilding& building, const ImportedConnection& connection) {
    std::optional<std::size_t> first;
    for (const ImportedStop& stop : connection.stops) {
      const auto level = std::ranges::find(building.levels, stop.level, &ImportedLevel::name);
      const Part* part =
          part_at(static_cast<std::size_t>(level - building.levels.begin()), stop.position);
      if (part == nullptr) continue;
      const std::size_t group = root(part->group);
      if (first)
        parts_[group].group = *first;
      else
        first = group;
    }
  }

  /// The kiosk is where most of the floor is.
  void choose() {
    std::map<std::size_t, double> area;
    for (const Part& part : parts_) area[root(part.group)] += part.shape.area();
    double most = 0;
    for (const auto& [group, floor] : area)
      if (floor > most) {
        most = floor;
        kiosk_group_ = group;
      }
  }

  std::vector<Part> parts_;
  std::size_t kiosk_group_ = 0;
};

class MuseumWriter {
 public:
  MuseumWriter(LaidBuilding& laid, const MuseumManner& manner)
      : laid_(laid), building_(laid.building), title_(manner.title), speaks_(manner.speaks) {}

  std::vector<MuseumText> texts() && {
    find_languages();
    parts_.emplace(laid_);
    write_head();
    for (std::size_t i = 0; i < building_.levels.size(); ++i) write_floor(i);
    write_kiosk();
    for (std::size_t i = 0; i < building_.levels.size(); ++i) write_rooms(i);
    write_connections();
    for (std::size_t i = 0; i < building_.levels.size(); ++i) write_doors(i);
    for (std::size_t i = 0; i < building_.levels.size(); ++i) write_places(i);
    files_.insert(files_.begin(), {"museum.toml", std::move(toml_)});
    return std::move(files_);
  }

 private:
  [[nodiscard]] bool is_written(std::size_t level) const {
    return !laid_.levels[level].floor.empty();
  }
  [[nodiscard]] bool is_written(const std::string& level) const {
    for (std::size_t i = 0; i < building_.levels.size(); ++i)
      if (building_.levels[i].name == level) return is_written(i);
    return false;
  }

  template <typename... Values>
  void line(fmt::format_string<Values...> text, Values&&... values) {
    toml_ += fmt::format(text, std::forward<Values>(values)...) + "\n";
  }

  /// The languages that nearly all names are in; a plan that knows none is taken for English.
  void find_languages() {
    std::map<std::string, std::size_t> count;
    std::size_t named = 0;
    for (const ImportedLevel& level : building_.levels)
      for (const ImportedRoom& room : level.rooms) {
        if (room.name.empty() && room.titles.empty()) continue;
        ++named;
        for (const auto& [language, title] : room.titles) ++count[language];
      }
    for (const auto& [language, times] : count)
      if (times * 10 >= named * 9 && speaks_(language)) languages_.push_back(language);
    if (languages_.empty()) languages_.emplace_back("en");
    const auto english = std::ranges::find(languages_, "en");
    if (english != languages_.end()) std::rotate(languages_.begin(), english, english + 1);
  }

  void write_titles(const Titles& titles, const std::string& name) {
    for (const std::string& language : languages_) {
      const auto title = titles.find(language);
      const std::string& text = title != titles.end() ? title->second : name;
      if (!text.empty()) line("title.{} = {}", language, in_quotes(text));
    }
    for (const auto& [language, text] : titles)
      if (std::ranges::find(languages_, language) == languages_.end())
        line("# title.{} = {}", language, in_quotes(text));
  }

  void write_head() {
    line("# Written by docent-content import from {}.", title_);
    line(
        "# It is yours: change what you like. A later import keeps what you have changed, and says "
        "so.");
    if (!building_.attribution.empty()) line("# The plan is by {}.", building_.attribution);
    line("# Positions are metres: [east, north].{}{}",
         building_.frame_said.empty() ? "" : " The plan gave ",
         building_.frame_said.empty() ? "" : building_.frame_said + ".");
    line("\n[museum]");
    for (const std::string& language : languages_)
      line("title.{} = {}", language, in_quotes(title_));
    std::string list;
    for (const std::string& language : languages_)
      list += (list.empty() ? "" : ", ") + in_quotes(language);
    line("languages = [{}]", list);
    if (building_.origin)
      line("origin = [{:.7f}, {:.7f}]   # Latitude and longitude of [0, 0].", building_.origin->y,
           building_.origin->x);
  }

  void write_floor(std::size_t index) {
    if (!is_written(index)) return;
    const ImportedLevel& level = building_.levels[index];
    const std::string file = fmt::format(
        "floors/{}.geojson", files_names_.take("level-" + ordinal_slug(level.ordinal), ""));
    line("\n[[floor]]");
    line("name = {}", in_quotes(level.name));
    line("ordinal = {}", static_cast<long>(std::floor(level.ordinal)));
    if (level.elevation)
      line("height = {}", number(*level.elevation));
    else if (level.ordinal != std::floor(level.ordinal))
      line("height = {}", number(4 * level.ordinal));
    if (!level.short_name.empty()) line("short = {}", in_quotes(level.short_name));
    write_titles(level.titles, fmt::format("Level {}", level.name));
    line("plan = {}", in_quotes(file));
    files_.push_back({file, plan_text(level, laid_.levels[index])});
  }

  static std::string plan_text(const ImportedLevel& level, const LaidLevel& laid) {
    std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
    std::string_view comma = "\n";
    for (const std::vector<BuildingRing>& rings : polygons_of(laid.floor)) {
      text += fmt::format(
          "{}{{\"type\": \"Feature\", \"properties\": {{\"floor\": {}}}, \"geometry\": "
          "{{\"type\": \"Polygon\", \"coordinates\": [",
          comma, in_quotes(level.name));
      std::string_view between;
      for (BuildingRing ring : rings) {
        ring.push_back(ring.front());
        text += fmt::format("{}{}", between, ring_text(ring));
        between = ",\n  ";
      }
      text += "]}}";
      comma = ",\n";
    }
    return text + "\n]}\n";
  }

  /// The kiosk stands where most of the building can be walked to, on the floor nearest to the
  /// ground, in the largest room there, until staff say where.
  void write_kiosk() {
    const std::optional<StandingPlace> kiosk = parts_->kiosk(building_);
    if (!kiosk) return;
    line("\n[kiosk]   # Say where it stands.");
    line("floor = {}", in_quotes(building_.levels[kiosk->level].name));
    line("position = {}", point(kiosk->at));
    line("facing = 90");
  }

  void write_rooms(std::size_t index) {
    if (!is_written(index)) return;
    const ImportedLevel& level = building_.levels[index];
    for (const ImportedRoom& room : level.rooms) {
      if (room.rings.empty() || (room.name.empty() && room.titles.empty())) continue;
      const auto english = room.titles.find("en");
      const std::string& called = english != room.titles.end() ? english->second : room.name;
      std::string id = slug(called);
      if (id.empty()) id = "room-" + slug(room.source_id);
      const std::string name =
          room.name.empty() && !room.titles.empty() ? room.titles.begin()->second : room.name;
      line("\n[[room]]");
      line("id = {}", in_quotes(ids_.take(id, "-" + ordinal_slug(level.ordinal))));
      line("floor = {}", in_quotes(level.name));
      write_titles(room.titles, name);
      line("label = {}", point(point_in(room, laid_.levels[index])));
      line("outline = {}", ring_text(outline_of(room)));
    }
  }

  void write_connections() {
    for (const ImportedConnection& connection : building_.connections) {
      std::string stops;
      std::size_t count = 0;
      for (const ImportedStop& stop : connection.stops) {
        if (!is_written(stop.level)) continue;
        ++count;
        stops +=
            fmt::format("{}  {{floor = {}, position = {}, facing = {}}}",
                        stops.empty() ? "\n" : ",\n", in_quotes(stop.level), point(stop.position),
                        std::lround(std::remainder(stop.facing * 180 / std::numbers::pi, 360)));
      }
      if (count < 2) continue;
      std::string id = slug(connection.name);
      if (id.empty()) id = connection.kind;
      line("\n[[connection]]");
      line("id = {}", in_quotes(connection_ids_.take(id, "")));
      line("kind = {}", in_quotes(connection.kind));
      if (!connection.direction.empty()) line("direction = {}", in_quotes(connection.direction));
      line("stops = [{}]", stops);
    }
  }

  [[nodiscard]] static std::string room_at(const ImportedLevel& level, Vec2 at) {
    for (const ImportedRoom& room : level.rooms)
      if (holds(shape_of(room.rings), at)) return room.name.empty() ? room.source_id : room.name;
    return {};
  }

  void write_doors(std::size_t index) {
    const ImportedLevel& level = building_.levels[index];
    for (const LaidDoor& laid : laid_.levels[index].doors) {
      const ImportedDoor& door = level.doors[laid.door];
      const Vec2 centre = (laid.a + laid.b) / 2.0,
                 across = left_of(glm::normalize(laid.b - laid.a)) * 0.3;
      std::string name = door.id;
      if (name.empty()) {
        const std::string one = room_at(level, centre + across),
                          two = room_at(level, centre - across);
        name = one.empty() || two.empty() ? one + two : fmt::format("{} to {}", one, two);
      }
      if (name.empty()) name = "door";
      name = door_names_.take(name, "");
      call_in_doubts(level.name, door.id, name);
      line("\n[[door]]");
      line("name = {}", in_quotes(name));
      line("floor = {}", in_quotes(level.name));
      line("a = {}", point(laid.a));
      line("b = {}", point(laid.b));
    }
  }

  /// Doubts speak of a door by the name that it has in the museum.
  void call_in_doubts(const std::string& level, const std::string& id, const std::string& name) {
    if (id == name || id.empty()) return;
    for (Doubt& doubt : building_.doubts) {
      if (doubt.level != level) continue;
      for (std::string* text : {&doubt.message, &doubt.hint})
        for (std::size_t at = 0; (at = text->find(id, at)) != std::string::npos;) {
          const std::size_t end = at + id.size();
          const bool is_whole = end == text->size() || !is_letter_or_digit((*text)[end]);
          if (is_whole) text->replace(at, id.size(), name);
          at += is_whole ? name.size() : id.size();
        }
    }
  }

  void write_places(std::size_t index) {
    if (!is_written(index)) return;
    const ImportedLevel& level = building_.levels[index];
    const Shape standing = grown(laid_.levels[index].floor, -body);
    for (const ImportedPlace& place : level.places) {
      Vec2 at = place.position;
      if (!settle(standing, at, 5) || !parts_->has_kiosk(index, at)) {
        building_.doubts.push_back(
            {"place-unreachable", level.name, place.position,
             fmt::format("no way leads to {}{}{}", place.kind, place.name.empty() ? "" : " ",
                         place.name),
             "draw the doors that lead there and import again, or write a [[place]]"});
        continue;
      }
      std::string id = slug(place.name);
      if (id.empty()) id = slug(place.kind);
      line("\n[[place]]");
      line("id = {}", in_quotes(place_ids_.take(id, "-" + ordinal_slug(level.ordinal))));
      line("kind = {}", in_quotes(place.kind));
      line("floor = {}", in_quotes(level.name));
      line("position = {}", point(at));
      if (!place.name.empty() || !place.titles.empty()) write_titles(place.titles, place.name);
    }
  }

  LaidBuilding& laid_;
  ImportedBuilding& building_;
  const std::string& title_;
  const std::function<bool(const std::string&)>& speaks_;
  std::optional<WalkableParts> parts_;
  Ids door_names_;  ///< Doors are closed by their names, so each has one of its own.
  std::vector<std::string> languages_;
  std::string toml_;
  std::vector<MuseumText> files_;
  Ids ids_, connection_ids_, place_ids_, files_names_;
};

/// Moves the stops of connections to where a body can stand, and leaves out those that cannot.
void settle_stops(LaidBuilding& laid) {
  ImportedBuilding& building = laid.building;
  constexpr double farthest = 4;
  std::vector<Shape> standing;
  for (const LaidLevel& level : laid.levels) standing.push_back(grown(level.floor, -body));
  for (ImportedConnection& connection : building.connections)
    std::erase_if(connection.stops, [&](ImportedStop& stop) {
      const auto level = std::ranges::find(building.levels, stop.level, &ImportedLevel::name);
      if (level == building.levels.end()) return true;
      const auto index = static_cast<std::size_t>(level - building.levels.begin());
      if (settle(standing[index], stop.position, farthest)) return false;
      building.doubts.push_back(
          {"stop-outside", stop.level, stop.position,
           fmt::format("the {} {} ends on level {} where no room is", connection.kind,
                       connection.name.empty() ? connection.source_id : connection.name,
                       stop.level),
           "draw the room or corridor that it leads to, or write its stop into museum.toml"});
      return true;
    });
}

/// Levels with rooms that no connection joins to another.
void tell_lonely_levels(ImportedBuilding& building) {
  if (building.levels.size() < 2) return;
  for (const ImportedLevel& level : building.levels) {
    const bool joined = std::ranges::any_of(building.connections, [&](const auto& connection) {
      return connection.stops.size() > 1 &&
             std::ranges::find(connection.stops, level.name, &ImportedStop::level) !=
                 connection.stops.end();
    });
    if (!joined && !level.rooms.empty())
      building.doubts.push_back(
          {"level-not-joined",
           level.name,
           {},
           fmt::format("no stairs, lift or ramp leads to level {}", level.name),
           "draw them in the plan, or write a [[connection]] into museum.toml"});
  }
}

}  // namespace

LaidBuilding lay_out(ImportedBuilding building) {
  LaidBuilding laid{.building = std::move(building), .levels = {}};
  for (const ImportedLevel& level : laid.building.levels)
    laid.levels.push_back(lay_out(level, laid.building.doubts));
  settle_stops(laid);
  tell_lonely_levels(laid.building);
  const bool rooms =
      std::ranges::any_of(laid.levels, [](const LaidLevel& level) { return !level.floor.empty(); });
  if (!rooms)
    laid.building.doubts.push_back(
        {"no-rooms",
         "",
         {},
         "no rooms: this plan has none, so there is nothing to walk on and no museum is written",
         "draw rooms and corridors as areas (indoor=room, indoor=corridor), or ask for the plan "
         "that has them"});
  return laid;
}

std::vector<MuseumText> museum_texts(LaidBuilding& laid, const MuseumManner& manner) {
  return MuseumWriter(laid, manner).texts();
}

double area_of(const ImportedRoom& room) {
  return shape_of(room.rings).area();
}

Vec2 point_in(const ImportedRoom& room, const LaidLevel& level) {
  const Shape drawn = shape_of(room.rings), walkable = common(drawn, level.floor);
  return middle_of(walkable.empty() ? drawn : walkable);
}

}  // namespace docent::import
