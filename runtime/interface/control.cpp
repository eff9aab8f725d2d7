#include "runtime/interface/control.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "runtime/interface/face.h"
#include "runtime/interface/finder.h"
#include "runtime/interface/goal.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/pictures.h"
#include "runtime/interface/places.h"
#include "runtime/scene/look.h"

namespace docent::interface {
namespace {

/// Leads to the list of tours by the time that one has.
Control times_control(const Museum& museum) {
  Control control = button(museum, "times", "times", {Action::Kind::ShowTimes});
  control.role = Role::ListItem;
  return control;
}

/// The visitor's own tour in the list.
Control own_tour_control(const Museum& museum) {
  Control control = button(museum, "own-tour", "own_tour", {Action::Kind::ShowOwnTour});
  control.role = Role::ListItem;
  return control;
}

/// Puts an exhibit into the visitor's own tour, or takes it out.
Control collect_control(const Museum& museum, std::uint32_t exhibit, const InterfaceState& state) {
  const bool is_in = place_in(state.own_tour, exhibit) != state.own_tour.count;
  const bool lists_it = state.screen == Screen::Choosing && state.lists == Listed::OwnTour;
  const std::string_view key = !is_in     ? "own_tour_add"
                               : lists_it ? "own_tour_remove"
                                          : "own_tour_added";
  Control control = button(museum, "collect:" + museum.exhibits[exhibit].id, key,
                           {is_in ? Action::Kind::Discard : Action::Kind::Collect, exhibit});
  control.selected = is_in && !lists_it;
  control.enabled = is_in || !state.own_tour.is_full();
  return control;
}

/// A kind of place in the list.
Control kind_control(const Museum& museum, PlaceKind kind, const InterfaceState& state) {
  Control control = button(museum, "place:" + std::string(info_of(kind).name), word_of(kind),
                           {Action::Kind::Seek, static_cast<std::uint32_t>(kind)});
  control.role = Role::ListItem;
  control.selected = state.seeks == kind;
  return control;
}

/// A place where it is on the model.
Control place_spot(const Museum& museum, std::uint32_t index, const InterfaceState& state) {
  const Place& place = museum.places[index];
  return {.name = "spot:" + place.id,
          .role = Role::Spot,
          .label = place.title.empty() ? word_in_all(museum, word_of(place.kind)) : place.title,
          .action = {Action::Kind::GoToPlace, index},
          .selected = state.place == index,
          .rect = {}};
}

/// To the tour's next stop, where there is one.
std::optional<Action> to_next_stop(const Museum& museum, const InterfaceState& state) {
  const std::optional<TourWalk> next = next_stop(museum, state.own_tour, state.tour);
  if (!next) return {};
  const std::uint32_t exhibit = stops_of(museum, state.own_tour, next)->exhibits[next->stop];
  return Action{Action::Kind::FollowTour, exhibit, *next};
}

void add_skip(const ControlRequest& request, std::vector<Control>& out) {
  if (const auto action = to_next_stop(request.museum, request.state))
    out.push_back(button(request.museum, "skip", "tour_skip", *action));
}

/// As an exhibit of the list; false where the tour has no further stop.
bool add_next(const ControlRequest& request, std::vector<Control>& out) {
  const auto action = to_next_stop(request.museum, request.state);
  if (!action) return false;
  Control next = exhibit_control(request.museum, action->argument, Role::ListItem, request.state);
  next.name = "next";
  next.action = *action;
  out.push_back(std::move(next));
  return true;
}

/// Each language is named in itself, whoever reads it.
LocalText name_of_language(const Museum& museum, std::uint32_t language) {
  LocalText name;
  for (const Language& reader : museum.languages)
    name[reader.tag] = museum.languages[language].name;
  return name;
}

Control language_control(const Museum& museum, std::uint32_t language, Role role,
                         const InterfaceState& state) {
  return {.name = "language:" + museum.languages[language].tag,
          .role = role,
          .label = name_of_language(museum, language),
          .action = {Action::Kind::Speak, language},
          .selected = state.language == language,
          .rect = {}};
}

void add_languages(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  const auto count = static_cast<std::uint32_t>(museum.languages.size());
  if (count < 2) return;
  // Who comes to a seat finds theirs at once.
  const bool is_first = state.screen == Screen::Welcome || state.screen == Screen::Picking;
  if (count > most_languages_beside && !is_first) {
    out.push_back({.name = "languages",
                   .label = name_of_language(museum, std::min(state.language, count - 1)),
                   .action = {Action::Kind::ShowLanguages},
                   .rect = {}});
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i)
    out.push_back(language_control(museum, i, Role::Choice, state));
}

void add_routes(const ControlRequest& request, std::vector<Control>& out) {
  for (Control& control : route_controls(request.museum, request.state.kind))
    out.push_back(std::move(control));
}

/// The guides, of whom those that others have cannot be picked.
void add_looks(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  for (std::uint32_t i = 0; i < scene::guide_look_count; ++i) {
    const std::string name(scene::looks[i].name);
    Control control = button(museum, "look:" + name, "look_" + name, {Action::Kind::Pick, i});
    control.role = Role::Choice;
    control.selected = state.look == i;
    control.enabled = (state.taken >> i & 1U) == 0;
    out.push_back(std::move(control));
  }
}

/// The visitor's own tour heads the list of exhibits as soon as there is one.
std::uint32_t own_tours(const InterfaceState& state) noexcept {
  return state.own_tour.count > 0 ? 1 : 0;
}

/// What heads the list of exhibits: the visitor's own tour, the way to tours by time, staff's
/// tours.
std::uint32_t rows_before_exhibits(const Museum& museum, const InterfaceState& state) noexcept {
  return own_tours(state) + (tours_for_time(museum) > 0 ? 1 : 0) + tours_of_staff(museum);
}

/// How long the list is: tours and exhibits, kinds of places, or the stops of the visitor's tour.
std::uint32_t list_length(const Museum& museum, const InterfaceState& state) noexcept {
  const auto is_there = [&](const PlaceKindInfo& info) { return has_place(museum, info.kind); };
  switch (state.lists) {
    case Listed::Exhibits:
      return rows_before_exhibits(museum, state) +
             static_cast<std::uint32_t>(museum.exhibits.size());
    case Listed::Times:
      return tours_for_time(museum);
    case Listed::Places:
      return static_cast<std::uint32_t>(std::ranges::count_if(place_kinds, is_there));
    case Listed::Languages:
      return static_cast<std::uint32_t>(museum.languages.size());
    case Listed::Found:
      return state.found.count;
    case Listed::OwnTour:
      break;
  }
  return state.own_tour.count;
}

/// Something that was found: an exhibit, a kind of place, or a place with a name of its own.
Control found_item(const Museum& museum, std::uint32_t entry, const InterfaceState& state) {
  const Action action = meant_by(museum, entry);
  if (action.kind == Action::Kind::Choose)
    return exhibit_control(museum, action.argument, Role::ListItem, state);
  if (action.kind == Action::Kind::Seek)
    return kind_control(museum, static_cast<PlaceKind>(action.argument), state);
  if (action.kind == Action::Kind::Browse) {
    const Group group = group_of(museum, entry);
    return {.name = group.name,
            .role = Role::ListItem,
            .label = *group.title,
            .action = action,
            .rect = {}};
  }
  Control control = place_spot(museum, action.argument, state);
  control.role = Role::ListItem;
  return control;
}

Control list_item(const Museum& museum, std::uint32_t index, const InterfaceState& state) {
  const auto exhibit = [&](std::uint32_t i) {
    return exhibit_control(museum, i, Role::ListItem, state);
  };
  if (state.lists == Listed::Places)
    return kind_control(museum, kinds_of_places(museum)[index], state);
  if (state.lists == Listed::Languages)
    return language_control(museum, index, Role::ListItem, state);
  if (state.lists == Listed::OwnTour) return exhibit(state.own_tour.exhibit[index]);
  const auto tour = [&](std::uint32_t i) { return tour_control(museum, i, Role::ListItem, state); };
  if (state.lists == Listed::Times) return tour(tours_of_staff(museum) + index);
  if (state.lists == Listed::Found) return found_item(museum, state.found.entry[index], state);
  if (index < own_tours(state)) return own_tour_control(museum);
  const std::uint32_t before = rows_before_exhibits(museum, state);
  if (index >= before) return exhibit(index - before);
  const std::uint32_t first_tour = before - tours_of_staff(museum);
  return index < first_tour ? times_control(museum) : tour(index - first_tour);
}

void add_list(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  const std::uint32_t pages = page_count(museum, state, per_page);
  const std::uint32_t page = std::min(state.page, pages - 1);
  const std::uint32_t begin = page * per_page;
  const std::uint32_t end = std::min(begin + per_page, list_length(museum, state));
  for (std::uint32_t i = begin; i < end; ++i) out.push_back(list_item(museum, i, state));
  if (pages == 1) return;

  Control previous = button(museum, "page:previous", "page_previous",
                            {Action::Kind::TurnPage, page == 0 ? 0 : page - 1});
  previous.enabled = page > 0;
  Control next = button(museum, "page:next", "page_next", {Action::Kind::TurnPage, page + 1});
  next.enabled = page + 1 < pages;
  out.push_back(std::move(previous));
  out.push_back(std::move(next));
}

/// The floors, the highest first, as they lie over one another.
void add_floors(const ControlRequest& request, std::vector<Control>& out) {
  const Museum& museum = request.museum;
  if (museum.floors.size() < 2) return;
  for (const std::uint32_t floor : floors_from_above(museum)) {
    const FloorPlan& plan = museum.floors[floor].plan;
    Control control{.name = "floor:" + plan.name,
                    .role = Role::Choice,
                    .label = museum.floors[floor].title,
                    .action = {Action::Kind::ShowFloor, floor},
                    .selected = floor == request.state.floor.value_or(museum.kiosk_floor),
                    .rect = {}};
    if (control.label.empty() && !museum.languages.empty())
      control.label[museum.languages.front().tag] = plan.short_name;
    out.push_back(std::move(control));
  }
}

void add_spots(const Museum& museum, const InterfaceState& state, std::vector<Control>& out) {
  const std::uint32_t floor = state.floor.value_or(museum.kiosk_floor);
  for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i)
    if (museum.exhibits[i].floor == floor)
      out.push_back(exhibit_control(museum, i, Role::Spot, state));
  for (std::uint32_t i = 0; i < museum.places.size(); ++i)
    if (museum.places[i].floor == floor) out.push_back(place_spot(museum, i, state));
}

// The controls of each screen: on a glass of one's own, and on a card.

void add_begin(const ControlRequest& request, std::vector<Control>& out) {
  out.push_back(button(request.museum, "begin", "begin", {Action::Kind::Begin}));
  if (request.state.can_resume)
    out.push_back(button(request.museum, "resume", "take_back", {Action::Kind::Resume}));
  if (request.state.glass == Glass::Whole) add_offers(request, out);
}
void add_join(const ControlRequest& request, std::vector<Control>& out) {
  out.push_back(button(request.museum, "begin", "join", {Action::Kind::Begin}));
}
void add_home(const ControlRequest& request, std::string_view key, std::vector<Control>& out) {
  out.push_back(button(request.museum, "home", key, {Action::Kind::Home}));
}
void add_choose(const ControlRequest& request, std::vector<Control>& out) {
  out.push_back(button(request.museum, "choose", "choose", {Action::Kind::ShowExhibits}));
}
void add_picking(const ControlRequest& request, std::vector<Control>& out) {
  add_looks(request, out);
  add_home(request, "leave", out);
  add_languages(request, out);
}
/// Back to where the visitor is led, or else home.
void add_back(const ControlRequest& request, std::string_view home_key, std::vector<Control>& out) {
  const InterfaceState& state = request.state;
  if (!has_goal(state)) return add_home(request, home_key, out);
  const std::string_view key = !state.arrived  ? "back"
                               : state.exhibit ? "back_to_exhibit"
                                               : "back_to_place";
  out.push_back(button(request.museum, "back", key, {Action::Kind::Return}));
}
/// Of the visitor's own tour; and what leads back to the exhibits.
void add_start(const ControlRequest& request, std::vector<Control>& out) {
  const OwnTour& tour = request.state.own_tour;
  Control start = button(request.museum, "start-tour", "own_tour_start",
                         {Action::Kind::FollowTour, tour.exhibit[0], {TourWalk::own, 0}});
  start.enabled = tour.is_ordered && tour.count > 0;
  out.push_back(std::move(start));
  out.push_back(button(request.museum, "choose", "own_tour_more", {Action::Kind::ShowExhibits}));
}
/// What collects the exhibits of the list.
void add_collects(const ControlRequest& request, std::vector<Control>& out) {
  const std::size_t listed = out.size();
  for (std::size_t i = 0; i < listed; ++i)
    if (out[i].role == Role::ListItem && out[i].action.kind == Action::Kind::Choose)
      out.push_back(collect_control(request.museum, out[i].action.argument, request.state));
}
/// What was found, so that it is read first; then the keys.
void add_searching(const ControlRequest& request, std::vector<Control>& out) {
  add_list(request, out);
  add_keys(request, out);
  add_back(request, "home", out);
}
void add_searching_on_card(const ControlRequest& request, std::vector<Control>& out) {
  add_list(request, out);
  add_keys(request, out);
  add_back(request, "leave", out);
}
void add_choosing(const ControlRequest& request, std::vector<Control>& out) {
  add_list(request, out);
  add_floors(request, out);
  if (request.state.lists == Listed::OwnTour)
    add_start(request, out);
  else
    add_routes(request, out);
  add_back(request, "home", out);
  add_collects(request, out);  // last, so that keys come to the exhibits soon
}
void add_choosing_on_card(const ControlRequest& request, std::vector<Control>& out) {
  add_list(request, out);
  if (request.state.lists == Listed::OwnTour)
    add_start(request, out);
  else
    add_languages(request, out);
  add_back(request, "leave", out);
  add_collects(request, out);
}
void add_walking_on_card(const ControlRequest& request, std::vector<Control>& out) {
  add_routes(request, out);
  out.push_back(button(request.museum, "stop", "stop", {Action::Kind::Stop}));
  add_skip(request, out);
  add_choose(request, out);
}
/// Of the exhibit that the visitor goes to, or is at.
void add_collect(const ControlRequest& request, std::vector<Control>& out) {
  const InterfaceState& state = request.state;
  if (!state.exhibit || *state.exhibit >= request.museum.exhibits.size()) return;
  out.push_back(collect_control(request.museum, *state.exhibit, state));
}
/// Along with the guide; who goes along already goes faster, and then as it walks again.
void add_walk(const ControlRequest& request, std::vector<Control>& out) {
  struct Pace {
    std::string_view word;
    std::uint32_t next;
  };
  constexpr std::array paces{Pace{"walk", 1}, Pace{"walk_twice", 2}, Pace{"walk_four", 4}};
  constexpr Pace slower{"walk_pace", 1};
  const Pace& pace = request.state.pace < paces.size() ? paces[request.state.pace] : slower;
  out.push_back(button(request.museum, "walk", pace.word, {Action::Kind::Walk, pace.next}));
}
/// For who goes along and has seen enough of this room.
void add_onward(const ControlRequest& request, std::vector<Control>& out) {
  constexpr std::array<std::string_view, 3> words{"skip_room", "skip_floor", "skip_goal"};
  if (request.state.pace == 0) return;
  const auto next = static_cast<std::size_t>(request.state.next);
  out.push_back(button(request.museum, "onward", words[next], {Action::Kind::GoOnward}));
}
void add_walking(const ControlRequest& request, std::vector<Control>& out) {
  add_walking_on_card(request, out);
  add_walk(request, out);
  add_onward(request, out);
  if (!to_next_stop(request.museum, request.state)) add_collect(request, out);
  add_home(request, "home", out);
}
/// What one may listen to: a button for each, which stops it while it plays.
void add_sounds(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  if (!can_listen(museum, state)) return;
  const std::span<const ExhibitSound> sounds = sounds_of(museum, *state.exhibit);
  for (std::uint32_t i = 0; i < sounds.size(); ++i) {
    const bool plays = state.sound == i;
    Control control =
        button(museum, fmt::format("sound:{}", i + 1), plays ? "sound_stop" : "sound_play",
               plays ? Action{Action::Kind::StopSound, i} : Action{Action::Kind::PlaySound, i});
    for (std::uint32_t language = 0; language < museum.languages.size(); ++language) {
      std::string& label = control.label[museum.languages[language].tag];
      label = filled_in(label, "title", in_language(museum, language, sounds[i].title));
    }
    out.push_back(std::move(control));
  }
}

/// Round and round through the exhibit's pictures, and to its longer text or back from that.
void add_closer_look(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  if (!state.exhibit || *state.exhibit >= museum.exhibits.size()) return;
  if (reads_more(museum, state)) {
    out.push_back(button(museum, "less", "less", {Action::Kind::TellMore, 0}));
    return;
  }
  const ShownPicture shown = shown_picture(museum, state, *state.exhibit);
  const auto at = static_cast<std::uint32_t>(shown.number - 1),
             count = static_cast<std::uint32_t>(shown.count);
  if (count > 1) {
    out.push_back(button(museum, "picture:next", "picture_next",
                         {Action::Kind::ShowPicture, (at + 1) % count}));
    out.push_back(button(museum, "picture:previous", "picture_previous",
                         {Action::Kind::ShowPicture, (at + count - 1) % count}));
  }
  if (shown_video(museum, state))
    out.push_back(state.plays
                      ? button(museum, "video:stop", "video_stop", {Action::Kind::PlayVideo, 0})
                      : button(museum, "video:play", "video_play", {Action::Kind::PlayVideo, 1}));
  add_sounds(request, out);
  if (!museum.exhibits[*state.exhibit].more.empty())
    out.push_back(button(museum, "more", "more", {Action::Kind::TellMore, 1}));
}
void add_arrived_on_card(const ControlRequest& request, std::vector<Control>& out) {
  add_closer_look(request, out);
  if (!reads_more(request.museum, request.state)) add_next(request, out);
  add_choose(request, out);
  add_home(request, "leave", out);
}
void add_arrived(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  add_closer_look(request, out);
  if (!reads_more(museum, state) && !add_next(request, out) && state.exhibit)
    for (const std::uint32_t next : neighbours(museum, *state.exhibit, suggestion_count))
      out.push_back(exhibit_control(museum, next, Role::ListItem, state));
  add_collect(request, out);
  add_choose(request, out);
  add_home(request, "home", out);
}

}  // namespace

Control exhibit_control(const Museum& museum, std::uint32_t exhibit, Role role,
                        const InterfaceState& state) {
  const Exhibit& it = museum.exhibits[exhibit];
  return {.name = "exhibit:" + it.id,
          .role = role,
          .label = it.title,
          .action = {Action::Kind::Choose, exhibit},
          .selected = state.exhibit == exhibit,
          .rect = {}};
}

Control tour_control(const Museum& museum, std::uint32_t index, Role role,
                     const InterfaceState& state) {
  const Tour& tour = museum.tours[index];
  Control control{.name = "tour:" + tour.id,
                  .role = role,
                  .label = {},
                  .action = {Action::Kind::FollowTour, tour.exhibits.front(), {index, 0}},
                  .selected = state.tour && state.tour->tour == index,
                  .rect = {}};
  for (std::uint32_t i = 0; i < museum.languages.size(); ++i)
    control.label[museum.languages[i].tag] = title_in(museum, i, tour);
  return control;
}

const Tour* begun_tour(const Museum& museum, const Control& control) noexcept {
  const bool begins = control.action.kind == Action::Kind::FollowTour && control.name != "next" &&
                      control.action.stop.stop == 0;
  const std::uint32_t tour = control.action.stop.tour;
  return begins && tour < museum.tours.size() ? &museum.tours[tour] : nullptr;
}

bool is_collect(const Control& control) noexcept {
  return control.action.kind == Action::Kind::Collect ||
         control.action.kind == Action::Kind::Discard;
}

LocalText word_in_all(const Museum& museum, std::string_view key) {
  LocalText label;
  for (std::uint32_t i = 0; i < museum.languages.size(); ++i)
    label[museum.languages[i].tag] = word(museum, i, key);
  return label;
}

Control button(const Museum& museum, std::string name, std::string_view key, Action action) {
  return {.name = std::move(name), .label = word_in_all(museum, key), .action = action, .rect = {}};
}

const std::array<ScreenFaces, 6> screens{{
    {Screen::Welcome, {add_begin, lay_out_welcome}, {add_join, lay_out_welcome_card}},
    {Screen::Picking, {add_begin, lay_out_welcome}, {add_picking, lay_out_picking_card}},
    {Screen::Choosing,
     {add_choosing, lay_out_choosing},
     {add_choosing_on_card, lay_out_choosing_card}},
    {Screen::Walking, {add_walking, lay_out_walking}, {add_walking_on_card, lay_out_walking_card}},
    {Screen::Arrived, {add_arrived, lay_out_arrived}, {add_arrived_on_card, lay_out_arrived_card}},
    {Screen::Searching,
     {add_searching, lay_out_searching},
     {add_searching_on_card, lay_out_searching_card}},
}};

std::vector<Control> route_controls(const Museum& museum, RouteKind selected,
                                    std::span<const RouteKindInfo> kinds) {
  std::vector<Control> out;
  const auto add = [&](const RouteKindInfo& info, const LocalText* title) {
    const std::string name(info.name);
    Control control = button(museum, "route:" + name, "route_" + name,
                             {Action::Kind::TakeRoute, static_cast<std::uint32_t>(info.kind)});
    if (title != nullptr)
      for (const auto& [tag, text] : *title) control.label.insert_or_assign(tag, text);
    control.role = Role::Choice;
    control.selected = selected == info.kind;
    out.push_back(std::move(control));
  };
  for (const WayOffer& offer : museum.ways)
    if (const auto& kind = info_of(offer.choice).kind) add(info_of(*kind), &offer.title);
  if (museum.ways.empty())
    for (const RouteKindInfo& info : kinds) add(info, nullptr);
  if (out.size() < 2) out.clear();  // no choice
  return out;
}

std::vector<Control> controls_of(const Museum& museum, const InterfaceState& state,
                                 std::uint32_t per_page) {
  std::vector<Control> out;
  const ControlRequest request{museum, state, per_page};
  if (state.seat) {
    faces_of(state.screen).card.add_controls(request, out);
    if (state.screen != Screen::Welcome) add_helps(request, out);
    return out;
  }
  if (state.glass == Glass::Whole) {
    faces_of(state.screen).whole.add_controls(request, out);
    add_languages(request, out);
    add_helps(request, out);
  }
  if (state.glass != Glass::Whole || shows_spots(state.screen)) add_spots(museum, state, out);
  if (!state.asks_to_stay) return out;
  for (Control& control : out) control.enabled = false;  // a touch anywhere says that they stay
  out.push_back(button(museum, "stay", "stay", {Action::Kind::Stay}));
  return out;
}

std::vector<std::uint32_t> floors_from_above(const Museum& museum) {
  std::vector<std::uint32_t> floors(museum.floors.size());
  std::iota(floors.begin(), floors.end(), 0U);
  std::ranges::stable_sort(floors, std::greater{},
                           [&](std::uint32_t i) { return museum.floors[i].plan.ordinal; });
  return floors;
}

std::vector<std::uint32_t> neighbours(const Museum& museum, std::uint32_t exhibit,
                                      std::size_t count) {
  const Exhibit& from = museum.exhibits[exhibit];
  std::vector<std::uint32_t> others;
  for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i)
    if (i != exhibit && museum.exhibits[i].floor == from.floor) others.push_back(i);
  const auto distance = [&](std::uint32_t i) {
    const Vec2 d = museum.exhibits[i].viewing_point.position - from.viewing_point.position;
    return dot(d, d);
  };
  std::ranges::stable_sort(others, {}, distance);
  others.resize(std::min(count, others.size()));
  return others;
}

std::uint32_t page_count(const Museum& museum, const InterfaceState& state,
                         std::uint32_t per_page) noexcept {
  const std::uint32_t count = list_length(museum, state);
  return std::max(1U, (count + per_page - 1) / std::max(1U, per_page));
}

std::string_view word(const Museum& museum, std::uint32_t language, std::string_view key) noexcept {
  for (const std::uint32_t candidate : {language, 0U}) {
    if (candidate >= museum.languages.size()) continue;
    const auto& words = museum.languages[candidate].words;
    if (const auto found = words.find(key); found != words.end()) return found->second;
  }
  return key;
}

std::string_view language_tag(const Museum& museum, std::uint32_t language) noexcept {
  return language < museum.languages.size() ? std::string_view(museum.languages[language].tag)
                                            : std::string_view();
}

std::string_view in_language(const Museum& museum, std::uint32_t language,
                             const LocalText& text) noexcept {
  for (const std::uint32_t candidate : {language, 0U}) {
    if (candidate >= museum.languages.size()) continue;
    if (const auto found = text.find(museum.languages[candidate].tag); found != text.end())
      return found->second;
  }
  return text.empty() ? std::string_view{} : std::string_view(text.begin()->second);
}

}  // namespace docent::interface
