/// The one rule of what pressing does.
#include <algorithm>

#include "runtime/interface/control.h"
#include "runtime/interface/goal.h"

namespace docent::interface {
namespace {

/// The visitor is led nowhere.
void forget_goal(InterfaceState& state) noexcept {
  state.exhibit.reset();
  state.seeks.reset();
  state.place.reset();
  state.tour.reset();
  state.arrived = false;
  state.picture.reset();
  state.plays = false;
  state.tells_more = false;
  state.pace = 0;
  state.next = Chapter::Goal;
  state.skips = false;
}

/// The guide leads the visitor to the goal, unless they are there.
void follow_guide(InterfaceState& state, bool is_there) noexcept {
  state.arrived = is_there;
  state.screen = is_there ? Screen::Arrived : Screen::Walking;
  if (state.seat && !state.look) state.screen = Screen::Picking;
}

void choose(InterfaceState& state, const Action& action) noexcept {
  const bool is_there = state.arrived && state.exhibit == action.argument;
  forget_goal(state);
  if (action.kind == Action::Kind::FollowTour) state.tour = action.stop;
  state.exhibit = action.argument;
  follow_guide(state, is_there);
}

/// Who is on the way to the nearest already, or there, goes on.
void seek(InterfaceState& state, PlaceKind kind) noexcept {
  if (state.seeks == kind) return follow_guide(state, state.arrived);
  forget_goal(state);
  state.seeks = kind;
  follow_guide(state, false);
}

void go_to_place(InterfaceState& state, std::uint32_t place) noexcept {
  const bool is_there = state.arrived && state.place == place;
  forget_goal(state);
  state.place = place;
  follow_guide(state, is_there);
}

void show_list(InterfaceState& state, Listed what) noexcept {
  state.screen = state.seat && !state.look ? Screen::Picking : Screen::Choosing;
  state.lists = what;
  state.page = 0;
}

/// Who is on the way to it goes there all the same, on no tour.
void discard(InterfaceState& state, std::uint32_t exhibit) noexcept {
  const std::size_t place = place_in(state.own_tour, exhibit);
  take_from(state.own_tour, exhibit);
  if (state.tour && state.tour->tour == TourWalk::own) {
    if (place == state.tour->stop) state.tour.reset();
    if (state.tour && place < state.tour->stop) --state.tour->stop;
  }
  if (state.own_tour.count == 0 && state.lists == Listed::OwnTour)
    show_list(state, Listed::Exhibits);
}

/// Other letters: what they find is not known yet.
void letters_changed(InterfaceState& state) noexcept {
  state.browses.reset();
  state.found = {};
  state.found.is_current = false;
  state.page = 0;
}

void search(InterfaceState& state) noexcept {
  // On a shared glass keys lie on a visitor's card.
  if (state.glass != Glass::Whole && !(state.seat && state.look)) return;
  state.screen = Screen::Searching;
  state.lists = Listed::Found;
  state.page = 0;
  if (state.typed.count == 0) letters_changed(state);
}

/// Whoever has chosen it from the list goes on where they were.
void speak(InterfaceState& state, std::uint32_t language) noexcept {
  state.language = language;
  if (state.typed.count > 0 && !state.browses) letters_changed(state);  // its own come first
  if (state.screen != Screen::Choosing || state.lists != Listed::Languages) return;
  show_list(state, Listed::Exhibits);
  if (has_goal(state)) state.screen = state.arrived ? Screen::Arrived : Screen::Walking;
}

/// A seat whose visitor has left.
InterfaceState vacated(const InterfaceState& state) noexcept {
  InterfaceState vacant;
  vacant.glass = state.glass;
  vacant.seats = state.seats;
  vacant.seat = state.seat;
  vacant.taken = state.taken;
  return vacant;
}

}  // namespace

/// Who does that goes on listening.
constexpr bool goes_on_listening(Action::Kind kind) noexcept {
  switch (kind) {
    case Action::Kind::Stay:
    case Action::Kind::Scroll:
    case Action::Kind::EnlargeLetters:
    case Action::Kind::RaiseContrast:
    case Action::Kind::Lower:
    case Action::Kind::Collect:
    case Action::Kind::Discard:
      return true;
    default:
      return false;
  }
}

InterfaceState after(InterfaceState state, Action action) noexcept {
  state.asks_to_stay = state.can_resume = false;
  if (!goes_on_listening(action.kind)) state.sound.reset();
  switch (action.kind) {
    case Action::Kind::Begin:
      show_list(state, Listed::Exhibits);
      break;
    case Action::Kind::Pick:
      if ((state.taken >> action.argument & 1U) != 0) break;
      state.look = action.argument;
      state.screen = has_goal(state) ? Screen::Walking : Screen::Choosing;
      state.page = 0;
      break;
    case Action::Kind::ShowExhibits:
      show_list(state, Listed::Exhibits);
      break;
    case Action::Kind::ShowPlaces:
      show_list(state, Listed::Places);
      break;
    case Action::Kind::ShowLanguages:
      show_list(state, Listed::Languages);
      break;
    case Action::Kind::ShowTimes:
      show_list(state, Listed::Times);
      break;
    case Action::Kind::Search:
      search(state);
      break;
    case Action::Kind::Type:
      type(state.typed, static_cast<char16_t>(action.argument));
      letters_changed(state);
      break;
    case Action::Kind::Erase:
      erase(state.typed);
      letters_changed(state);
      break;
    case Action::Kind::Browse:
      state.typed = {};
      letters_changed(state);
      state.browses = action.argument;
      break;
    case Action::Kind::Clear:
      state.typed = {};
      letters_changed(state);
      break;
    case Action::Kind::TypeNumbers:
      state.types_numbers = action.argument != 0;
      break;
    case Action::Kind::Collect:
      add_to(state.own_tour, action.argument);
      break;
    case Action::Kind::Discard:
      discard(state, action.argument);
      break;
    case Action::Kind::ShowOwnTour:
      show_list(state, state.own_tour.count == 0 ? Listed::Exhibits : Listed::OwnTour);
      break;
    case Action::Kind::Choose:
    case Action::Kind::FollowTour:
      choose(state, action);
      break;
    case Action::Kind::Seek:
      seek(state, static_cast<PlaceKind>(action.argument));
      break;
    case Action::Kind::GoToPlace:
      go_to_place(state, action.argument);
      break;
    case Action::Kind::TurnPage:
      state.page = action.argument;
      break;
    case Action::Kind::ShowFloor:
      state.floor = action.argument;
      break;
    case Action::Kind::ShowPicture:
      state.picture = static_cast<std::uint8_t>(
          std::min<std::uint32_t>(action.argument, FurtherPicture::most - 1));
      state.plays = true;  // where it is a video
      break;
    case Action::Kind::PlayVideo:
      state.plays = action.argument != 0;
      break;
    case Action::Kind::PlaySound:
      state.sound = static_cast<std::uint8_t>(
          std::min<std::uint32_t>(action.argument, ExhibitSound::most - 1));
      state.plays = false;  // what moves and sounds at once is neither seen nor heard
      break;
    case Action::Kind::StopSound:
      break;
    case Action::Kind::TellMore:
      state.tells_more = action.argument != 0;
      state.plays = false;
      if (!state.tells_more) state.picture.reset();  // the short text is read from its beginning
      break;
    case Action::Kind::Speak:
      speak(state, action.argument);
      break;
    case Action::Kind::TakeRoute:
      state.kind = static_cast<RouteKind>(action.argument);
      break;
    case Action::Kind::AvoidSteps:
      state.ways.step_free = action.argument != 0;
      order_anew(state.own_tour);
      break;
    case Action::Kind::AvoidEscalators:
      state.ways.no_escalators = action.argument != 0;
      order_anew(state.own_tour);
      break;
    case Action::Kind::ReadAloud:
      state.speaks = action.argument != 0;
      break;
    case Action::Kind::EnlargeLetters:
      state.large_letters = action.argument != 0;
      state.page = 0;  // pages hold less
      break;
    case Action::Kind::RaiseContrast:
      state.high_contrast = action.argument != 0;
      break;
    case Action::Kind::Lower:
      state.low_reach = action.argument != 0;
      state.page = 0;
      break;
    case Action::Kind::Return:
      if (!has_goal(state)) {
        state.screen = Screen::Welcome;
        state.floor.reset();
      } else
        state.screen = state.arrived ? Screen::Arrived : Screen::Walking;
      state.picture.reset();  // who has been elsewhere is told all of it
      state.plays = false;
      break;
    case Action::Kind::GoOnward:
      state.skips = true;
      break;
    case Action::Kind::Walk:
      state.skips = false;
      state.pace = static_cast<std::uint8_t>(std::clamp(action.argument, 1U, fastest_pace));
      break;
    case Action::Kind::Stop:
      forget_goal(state);
      show_list(state, Listed::Exhibits);
      break;
    case Action::Kind::Home:
      if (state.seat) return vacated(state);
      state.can_resume = state.screen != Screen::Welcome;
      forget_goal(state);
      state.floor.reset();
      state.kind = state.usual_kind;
      state.ways = {};
      state.own_tour = {};
      state.typed = {};
      state.found = {};
      state.browses.reset();
      state.types_numbers = false;
      show_list(state, Listed::Exhibits);
      state.screen = Screen::Welcome;
      break;
    case Action::Kind::Stay:
    case Action::Kind::Scroll:
    case Action::Kind::Resume:
      break;
  }
  if (state.screen != Screen::Arrived) state.sound.reset();
  if (state.screen != Screen::Arrived) state.plays = false;  // nor does it begin on the way back
  return state;
}

}  // namespace docent::interface
