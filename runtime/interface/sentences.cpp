#include "runtime/interface/sentences.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/control.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/utterance.h"

namespace docent::interface {
namespace {

using directions::Directions;
using directions::DoorStep;
using directions::FloorPart;

constexpr std::array<std::string_view, directions::side_count> side_names{
    "ahead", "left", "right", "behind", "behind_left", "behind_right"};
constexpr std::array<std::string_view, 5> where_names{"ahead", "left", "right", "behind", "middle"};
constexpr std::array<std::string_view, 4> setting_names{"floor", "wall", "case", "place"};
constexpr std::array<std::string_view, connection_kind_count> ride_names{"stairs", "escalator",
                                                                         "lift", "ramp"};
constexpr std::uint32_t most_counted = 9;  ///< There are words for so many doors.
constexpr std::size_t most_rooms = 3, most_turns = 3;

std::string_view name_of(directions::Side side) noexcept {
  return side_names[static_cast<std::size_t>(side)];
}

/// Says one way in one language.
class Speaker {
 public:
  /// `spoken`: what fills a hole is kept apart from its sentence, as speech is made of pieces.
  Speaker(const Museum& museum, std::uint32_t language, bool spoken)
      : museum_(museum), language_(language), spoken_(spoken) {}

  std::string way(const Directions& directions) const;
  std::string goal(const directions::GoalPart& goal) const;
  std::string figures(const Directions& directions) const;

 private:
  std::string_view say(std::string_view key) const { return word(museum_, language_, key); }
  std::string fill(std::string_view text, std::string_view name, std::string_view value) const {
    return filled_in(text, name, spoken_ ? apart(value) : std::string(value));
  }
  std::string distance(double metres) const {
    return spoken_ ? spoken_distance(museum_, language_, metres)
                   : distance_in(museum_, language_, metres);
  }
  std::string time(double seconds) const {
    return spoken_ ? spoken_time(museum_, language_, seconds)
                   : time_in(museum_, language_, seconds);
  }
  std::string begun(std::string text) const {
    return spoken_ ? text : capitalised(std::move(text));
  }
  std::string quoted(const LocalText& title) const {
    return fill(say("way_room"), "room", in_language(museum_, language_, title));
  }
  std::string room(std::uint32_t index) const {
    return index < museum_.rooms.size() ? quoted(museum_.rooms[index].title) : std::string();
  }
  std::string rooms(const std::vector<std::uint32_t>& passed) const;
  std::string door(const DoorStep& step) const;
  std::string ride(const directions::RideStep& ride) const;
  void add_turns(const FloorPart& part, std::vector<std::string>& phrases) const;
  void add_doors(const FloorPart& part, std::vector<std::string>& phrases) const;

  const Museum& museum_;
  std::uint32_t language_;
  bool spoken_;
};

/// "A", "A and B", "A, B and C": of many rooms the first and the last two.
std::string Speaker::rooms(const std::vector<std::uint32_t>& passed) const {
  std::vector<std::uint32_t> named = passed;
  if (named.size() > most_rooms) named = {passed[0], passed[passed.size() - 2], passed.back()};
  std::string list;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (i == 0) {
      list = room(named[i]);
      continue;
    }
    const std::string more(say(i + 1 == named.size() ? "way_rooms_last" : "way_rooms"));
    list = fill(fill(more, "rooms", list), "room", room(named[i]));
  }
  return list;
}

std::string Speaker::door(const DoorStep& step) const {
  if (step.of == 0 && step.to == none) return std::string(say("way_straight"));
  if (step.of == 0) return fill(say("way_into"), "room", room(step.to));
  if (step.of == 1) return std::string(say(fmt::format("door_{}", name_of(step.side))));
  if (step.nth > most_counted)
    return step.to == none ? std::string(say(fmt::format("door_{}", name_of(step.side))))
                           : fill(say("door_to"), "room", room(step.to));
  return filled_in(say(fmt::format("door_{}_nth", name_of(step.side))), "nth",
                   say(fmt::format("door_nth_{}", step.nth)));
}

std::string Speaker::ride(const directions::RideStep& ride) const {
  const Floor& floor = museum_.floors[ride.floor];
  const std::string_view title = in_language(museum_, language_, floor.title);
  const std::string key = fmt::format("ride_{}_{}", ride_names[static_cast<std::size_t>(ride.kind)],
                                      ride.up ? "up" : "down");
  const std::string_view name = title.empty() ? std::string_view(floor.plan.name) : title;
  return fill(say(key), "floor", fill(say("way_room"), "room", name));
}

void Speaker::add_turns(const FloorPart& part, std::vector<std::string>& phrases) const {
  constexpr double at_once = 2;  // metres
  const std::size_t count = std::min(part.turns.size(), most_turns);
  for (std::size_t i = 0; i < count; ++i) {
    const directions::Turn& turn = part.turns[i];
    const bool now = turn.after < at_once;
    phrases.push_back(fill(say(fmt::format("turn_{}{}", name_of(turn.side), now ? "_now" : "")),
                           "distance", distance(turn.after)));
  }
  if (count == 0 && part.room == none) phrases.emplace_back(say("way_straight"));
}

void Speaker::add_doors(const FloorPart& part, std::vector<std::string>& phrases) const {
  if (part.doors.empty()) return;
  std::vector<std::uint32_t> passed;
  for (const DoorStep& step : part.doors)
    if (step.to != none) passed.push_back(step.to);
  if (!part.then && part.doors.back().to != none) passed.pop_back();  // that is the goal's
  const DoorStep& first = part.doors.front();
  const bool goes_without_saying = first.side == directions::Side::Ahead && first.of <= 1;
  const bool goes_on = part.then ? !passed.empty() : part.doors.size() > 1;
  if (goes_on && !goes_without_saying && first.of > 0) phrases.push_back(door(first));
  if (!passed.empty()) phrases.push_back(fill(say("way_through"), "rooms", rooms(passed)));
  if (!part.then) phrases.push_back(door(part.doors.back()));
}

std::string Speaker::way(const Directions& directions) const {
  std::vector<std::string> phrases;
  for (std::size_t i = 0; i < directions.parts.size(); ++i) {
    const FloorPart& part = directions.parts[i];
    const bool is_between = i > 0 && i + 1 < directions.parts.size();
    if (!is_between) {
      add_turns(part, phrases);
      add_doors(part, phrases);
    }
    if (part.then) phrases.push_back(ride(*part.then));
  }
  std::string text;
  for (const std::string& phrase : phrases)
    text = text.empty() ? phrase : fill(fill(say("way_then"), "way", text), "next", phrase);
  if (text.empty()) text = say("way_here");
  return begun(fill(say("way_sentence"), "way", text));
}

std::string Speaker::goal(const directions::GoalPart& goal) const {
  std::string where(
      say(fmt::format("where_{}", where_names[static_cast<std::size_t>(goal.where)])));
  if (goal.beside < museum_.places.size()) {
    const std::string key =
        fmt::format("beside_{}", info_of(museum_.places[goal.beside].kind).name);
    where = fill(fill(say("where_beside"), "where", where), "beside", say(key));
  }
  const bool is_somewhere = goal.room < museum_.rooms.size();
  const std::string key =
      fmt::format("goal_{}{}", setting_names[static_cast<std::size_t>(goal.setting)],
                  is_somewhere ? "_in" : "");
  const std::string text = fill(say(key), "where", where);
  return begun(fill(text, "room", room(goal.room)));
}

std::string Speaker::figures(const Directions& directions) const {
  std::string text(say(directions.step_free ? "way_figures" : "way_figures_steps"));
  text = fill(text, "distance", distance(directions.metres));
  return begun(fill(text, "time", time(directions.seconds)));
}

}  // namespace

std::string capitalised(std::string text) {
  if (text.empty()) return text;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) >= 'a' && byte(0) <= 'z') {
    text[0] = static_cast<char>(byte(0) - 'a' + 'A');
    return text;
  }
  if (text.size() < 2 || (byte(0) & 0xE0U) != 0xC0U) return text;
  unsigned letter = (byte(0) & 0x1FU) << 6U | (byte(1) & 0x3FU);
  const auto is_in = [&](unsigned low, unsigned high) { return letter >= low && letter <= high; };
  if ((is_in(0xE0, 0xFE) && letter != 0xF7) || is_in(0x3B1, 0x3C9) || is_in(0x430, 0x44F))
    letter -= letter == 0x3C2 ? 0 : 0x20;
  else if (is_in(0x450, 0x45F))
    letter -= 0x50;
  else if (is_in(0x100, 0x137) || is_in(0x14A, 0x177))
    letter -= letter % 2;
  text[0] = static_cast<char>(0xC0U | letter >> 6U);
  text[1] = static_cast<char>(0x80U | (letter & 0x3FU));
  return text;
}

namespace {

WaySentences said_by(const Speaker& speaker, const Directions& directions) {
  return {speaker.way(directions), speaker.goal(directions.goal), speaker.figures(directions)};
}

}  // namespace

WaySentences sentences_in(const Museum& museum, std::uint32_t language,
                          const Directions& directions) {
  return said_by(Speaker(museum, language, false), directions);
}

WaySentences spoken_sentences_in(const Museum& museum, std::uint32_t language,
                                 const Directions& directions) {
  return said_by(Speaker(museum, language, true), directions);
}

}  // namespace docent::interface
