#include "tests/runtime/interface/any_request.h"

#include <fmt/format.h>
#include <rapidcheck.h>

namespace docent::interface {

namespace {

/// One exhibit in two has something to listen to, some of it in many words.
void add_sounds(Museum& museum) {
  museum.sounds.clear();
  museum.sound_cues.clear();
  const auto count = static_cast<std::uint32_t>(museum.exhibits.size());
  for (std::uint32_t i = 0; i < count; i += 2)
    for (std::uint32_t n = 0; n <= i % ExhibitSound::most; ++n) {
      const auto sound = static_cast<std::uint32_t>(museum.sounds.size());
      museum.sounds.push_back({.exhibit = i,
                               .title = museum.exhibits[(i + n) % count].title,
                               .description = museum.exhibits[(i + n) % count].description});
      for (std::uint32_t language = 0; language < museum.languages.size(); ++language)
        for (const std::uint32_t second : {0U, 5U})
          museum.sound_cues.push_back(
              {.sound = sound,
               .language = language,
               .begin = 1000 * second,
               .end = 1000 * second + 4000,
               .text = std::string(in_language(museum, language, museum.exhibits[i].title))});
    }
}

}  // namespace

void add_pictures_and_more(Museum& museum) {
  add_sounds(museum);
  museum.pictures.clear();
  const auto count = static_cast<std::uint32_t>(museum.exhibits.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t further = i % 3 == 0 ? 0 : i % 3 == 1 ? 2 : FurtherPicture::most - 1;
    for (std::uint32_t n = 0; n < further; ++n)
      museum.pictures.push_back(
          {.exhibit = i,
           .image = museum.exhibits[(i + n) % count].image,
           .caption = n % 2 == 0 ? museum.exhibits[n % count].title : LocalText{},
           .description = n % 2 == 1 ? museum.exhibits[n % count].description : LocalText{}});
    Exhibit& exhibit = museum.exhibits[i];
    exhibit.more.clear();
    if (i % 2 == 0) continue;
    for (const auto& [tag, text] : exhibit.text)
      for (int paragraph = 0; paragraph < 8; ++paragraph) exhibit.more[tag] += text + "\n";
  }
}

void look_closer(InterfaceState& state) {
  state.can_sound = *rc::gen::arbitrary<bool>();
  if (*rc::gen::inRange(0, 3) == 0)
    state.sound = static_cast<std::uint8_t>(*rc::gen::inRange<std::size_t>(0, ExhibitSound::most));

  if (*rc::gen::arbitrary<bool>())
    state.picture = static_cast<std::uint8_t>(*rc::gen::inRange<std::size_t>(0, 20));
  state.tells_more = *rc::gen::arbitrary<bool>();
}

directions::Directions any_directions(const Museum& museum) {
  using namespace directions;
  const auto rooms = static_cast<std::uint32_t>(museum.rooms.size());
  const auto places = static_cast<std::uint32_t>(museum.places.size());
  const auto room = [&] {
    return *rc::gen::oneOf(rc::gen::inRange(0U, rooms), rc::gen::just(none));
  };
  Directions way;
  for (int parts = *rc::gen::inRange(1, 4); parts > 0; --parts) {
    FloorPart& part = way.parts.emplace_back();
    part.room = room();
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
      const auto of = *rc::gen::inRange(0U, 12U);
      part.doors.push_back({.from = part.last_room(),
                            .to = room(),
                            .side = static_cast<directions::Side>(*rc::gen::inRange(0, 6)),
                            .nth = of == 0 ? 0 : *rc::gen::inRange(1U, of + 1),
                            .of = of});
    }
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
      part.turns.push_back(
          {static_cast<directions::Side>(*rc::gen::inRange(1, 4)), *rc::gen::inRange(0, 90) / 1.0});
    if (parts > 1)
      part.then = RideStep{static_cast<ConnectionKind>(*rc::gen::inRange(0, 4)),
                           *rc::gen::arbitrary<bool>(), *rc::gen::inRange(0U, 2U)};
  }
  way.goal = {.room = room(),
              .setting = static_cast<Setting>(*rc::gen::inRange(0, 4)),
              .where = static_cast<Where>(*rc::gen::inRange(0, 5)),
              .beside = none};
  // Only what everybody finds has a word for what is beside it.
  const std::uint32_t beside = *rc::gen::inRange(0U, places);
  const std::string word = fmt::format("beside_{}", info_of(museum.places[beside].kind).name);
  if (museum.languages.front().words.contains(word)) way.goal.beside = beside;
  way.metres = *rc::gen::inRange(1, 5000);
  way.seconds = way.metres / *rc::gen::element(0.4, 1.0, 2.0);
  way.step_free = *rc::gen::arbitrary<bool>();
  return way;
}

ViewRequest any_request(const Museum& museum) {
  ViewRequest request;
  InterfaceState& state = request.state;
  state.screen =
      *rc::gen::element(Screen::Welcome, Screen::Choosing, Screen::Walking, Screen::Arrived);
  state.language = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.languages.size()));
  state.lists = *rc::gen::element(Listed::Exhibits, Listed::Places, Listed::Languages);
  state.page = *rc::gen::inRange(0U, 8U);
  state.arrived = state.screen == Screen::Arrived;
  state.asks_to_stay = *rc::gen::inRange(0, 5) == 0;
  if (*rc::gen::arbitrary<bool>())
    state.exhibit = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.exhibits.size()));
  else if (*rc::gen::arbitrary<bool>())
    state.place = *rc::gen::inRange(0U, static_cast<std::uint32_t>(museum.places.size()));
  else
    state.seeks = museum.places[*rc::gen::inRange<std::size_t>(0, museum.places.size())].kind;
  look_closer(state);
  if (state.exhibit && *rc::gen::arbitrary<bool>())
    state.tour = TourWalk{0, *rc::gen::inRange(0U, 7U)};
  if (*rc::gen::arbitrary<bool>()) {
    request.route_summary = RouteSummary{path::RouteStatus::Ok, 42.4, 55};
    if (*rc::gen::arbitrary<bool>())
      request.route_summary = RouteSummary{
          .status = path::RouteStatus::NoRoute,
          .hindrance = *rc::gen::element(Hindrance::Door, Hindrance::Lift, Hindrance::Steps)};
  }
  return request;
}

}  // namespace docent::interface
