/// Which controls lead where: what scripted visits and tests go by.
#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "runtime/interface/face.h"
#include "runtime/interface/goal.h"
#include "runtime/interface/places.h"
#include "runtime/model/moving_picture.h"

namespace docent::interface {
namespace {

/// A state reached while searching, and how.
struct Reached {
  InterfaceState state;
  std::size_t parent = 0;
  Control by;
};

std::vector<Control> touches_back_from(const std::deque<Reached>& reached, std::size_t last) {
  std::vector<Control> touches;
  for (; last != 0; last = reached[last].parent) touches.push_back(reached[last].by);
  std::ranges::reverse(touches);
  return touches;
}

/// Does the guide set out at once?
bool leads_away(const Action& action) noexcept {
  return action.kind == Action::Kind::Choose || action.kind == Action::Kind::FollowTour ||
         action.kind == Action::Kind::Seek || action.kind == Action::Kind::GoToPlace;
}

bool types(const Action& action) noexcept {
  return action.kind == Action::Kind::Type || action.kind == Action::Kind::Erase ||
         action.kind == Action::Kind::Clear;
}

/// How they see and hear the glass, or what they search for: it leads nowhere.
bool changes_senses(const Action& action) noexcept {
  return types(action) || action.kind == Action::Kind::ReadAloud ||
         action.kind == Action::Kind::EnlargeLetters ||
         action.kind == Action::Kind::RaiseContrast || action.kind == Action::Kind::Lower;
}

/// Their tour, or the guide who leads them.
bool loses_something(const InterfaceState& state, const Action& action) noexcept {
  return action.kind == Action::Kind::Home && (state.own_tour.count > 0 || has_goal(state));
}

/// Which touches a search may use.
enum class Reach : std::uint8_t {
  Panel,     ///< The panel's controls, without sending the guide anywhere or collecting anything.
  Model,     ///< Also exhibits on the model.
  Anything,  ///< Also setting out and collecting, where only that leads to the wanted control.
};

/// Breadth first over the control graph, so the answer has the fewest touches.
std::vector<Control> search(const Museum& museum, const InterfaceState& from,
                            std::uint32_t per_page, std::string_view name, std::size_t most,
                            Reach reach) {
  std::deque<Reached> reached{{from, 0, {}}};
  std::vector<std::size_t> depth{0};
  for (std::size_t at = 0; at < reached.size(); ++at) {
    if (depth[at] == most) break;
    for (Control& control : controls_of(museum, reached[at].state, per_page)) {
      if (!control.enabled || (control.role == Role::Spot && reach == Reach::Panel)) continue;
      const bool found = control.name == name;
      const InterfaceState state = after(reached[at].state, control.action);
      const bool changes_more = leads_away(control.action) || is_collect(control) ||
                                loses_something(reached[at].state, control.action);
      if (!found && changes_senses(control.action)) continue;
      if (!found && changes_more && reach != Reach::Anything) continue;
      if (!found &&
          std::ranges::any_of(reached, [&](const Reached& r) { return r.state == state; }))
        continue;
      depth.push_back(depth[at] + 1);
      reached.push_back({state, at, std::move(control)});
      if (found) return touches_back_from(reached, reached.size() - 1);
    }
  }
  return {};
}

}  // namespace

std::vector<Control> touches_to(const Museum& museum, const InterfaceState& state,
                                std::uint32_t per_page, std::string_view name, std::size_t most) {
  for (const Reach reach : {Reach::Panel, Reach::Model, Reach::Anything})
    if (auto touches = search(museum, state, per_page, name, most, reach); !touches.empty())
      return touches;
  return {};
}

bool is_control_name(const Museum& museum, std::string_view name) {
  if (turns_what_scrolls(name)) return true;
  const std::uint32_t per_page = 1;  // the paging controls exist where there are two exhibits
  const auto has_it = [&](const InterfaceState& state) {
    const std::vector<Control> controls = controls_of(museum, state, per_page);
    return std::ranges::any_of(controls, [&](const Control& c) { return c.name == name; });
  };
  for (const ScreenFaces& faces : screens)
    for (const bool is_led : {false, true}) {
      if (is_led && museum.exhibits.empty()) continue;
      InterfaceState state;
      state.screen = faces.screen;
      if (is_led) state.exhibit = 0;
      if (has_it(state)) return true;
      for (std::uint32_t tour = 0; is_led && tour < museum.tours.size(); ++tour) {
        if (name == "tour:" + museum.tours[tour].id) return true;
        state.tour = TourWalk{tour, 0};
        if (has_it(state)) return true;
      }
    }
  if (name == "stay" || name == "resume" || name == "lower" || name == "onward") return true;
  for (std::uint32_t floor = 0; floor < museum.floors.size(); ++floor) {
    InterfaceState above;
    above.screen = Screen::Choosing;
    above.floor = floor;
    for (const Listed what : {Listed::Exhibits, Listed::Places}) {
      above.lists = what;
      if (has_it(above)) return true;
    }
  }
  for (const Exhibit& exhibit : museum.exhibits)
    if (name == "collect:" + exhibit.id || name == "subject:" + exhibit.id ||
        name == "period:" + exhibit.id)
      return true;
  for (const Room& room : museum.rooms)
    if (name == "gallery:" + room.id) return true;
  if (name == "picture:previous" || name == "picture:next") return !museum.pictures.empty();
  if (name == "video:play" || name == "video:stop")
    return std::ranges::any_of(museum.images, is_video);
  for (const ExhibitSound& sound : museum.sounds)
    if (name == fmt::format("sound:{}", &sound - sounds_of(museum, sound.exhibit).data() + 1))
      return true;
  if (name == "more" || name == "less")
    return std::ranges::any_of(museum.exhibits, [](const Exhibit& e) { return !e.more.empty(); });
  if (name == "languages") return museum.languages.size() > most_languages_beside;
  if (name == "own-tour" || name == "start-tour") return !museum.exhibits.empty();
  InterfaceState searching;
  searching.screen = Screen::Searching;
  for (const bool numbers : {false, true}) {
    searching.types_numbers = numbers;
    for (searching.language = 0; searching.language < museum.languages.size(); ++searching.language)
      if (has_it(searching)) return true;
  }
  for (const PlaceKind kind : kinds_of_places(museum))
    if (name == "place:" + std::string(info_of(kind).name)) return true;
  InterfaceState picking;
  picking.screen = Screen::Picking;
  picking.glass = Glass::Busy;
  picking.seat = 1;
  return has_it(picking);
}

}  // namespace docent::interface
