#include "runtime/interface/speech.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "runtime/interface/finder.h"
#include "runtime/interface/goal.h"
#include "runtime/interface/keyboard.h"
#include "runtime/interface/layout.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/pictures.h"
#include "runtime/interface/places.h"
#include "runtime/interface/sentences.h"
#include "runtime/model/exhibit/room_of.h"

namespace docent::interface {
namespace {

constexpr std::array<float, 6> milestones{100, 50, 30, 20, 10, 5};  ///< Metres that remain.

std::string_view role_word(Role role) noexcept {
  switch (role) {
    case Role::Button:
      return "role_button";
    case Role::ListItem:
      return "role_item";
    case Role::Spot:
      return "role_spot";
    case Role::Choice:
      return "role_choice";
  }
  return "role_button";
}

/// Can anything be said in a language? Recordings of the museum's sounds sort before what is said.
bool is_spoken(const Museum& museum, std::uint32_t language) noexcept {
  const auto after = std::ranges::upper_bound(museum.speech, language, {}, &SpeechSound::language);
  return after != museum.speech.begin() && std::prev(after)->language == language &&
         !is_recording(*std::prev(after));
}

/// The language in which those hear what a kiosk says who read this one: itself, but where nothing
/// can be said in it the first of the museum's in which something can. Nobody is left in silence.
std::uint32_t heard_language(const Museum& museum, std::uint32_t language) noexcept {
  if (is_spoken(museum, language)) return language;
  for (std::uint32_t other = 0; other < museum.languages.size(); ++other)
    if (is_spoken(museum, other)) return other;
  return language;
}

bool is_of_sound(const Action& action) noexcept {
  return action.kind == Action::Kind::PlaySound || action.kind == Action::Kind::StopSound;
}

/// Composes what is said of one view.
class Composer {
 public:
  Composer(const Museum& museum, const ViewRequest& request, const Closures& closed,
           const ShownWay* way)
      : museum_(museum),
        request_(request),
        state_(request.state),
        closed_(closed),
        way_(way),
        language_(heard_language(museum, request.state.language)) {}

  Utterance control(const Control& control) const;
  Utterance opening() const;
  Utterance help() const;
  std::vector<CountedUtterance> remaining() const;
  Utterance said(std::string_view text) const {
    Utterance utterance = begun_in(language_);
    append_spoken(utterance, text);
    return utterance;
  }
  std::string said_key(std::uint32_t letter) const;
  void add_sound(Utterance& out, const Action& action) const;
  bool is_on_keyboard(char16_t letter) const;
  std::string_view say(std::string_view key) const { return word(museum_, language_, key); }

 private:
  Utterance begun_in(std::uint32_t language) const {
    return {.language = language < museum_.languages.size() ? museum_.languages[language].tag : "",
            .pieces = {}};
  }
  std::string_view local(const LocalText& text) const {
    return in_language(museum_, language_, text);
  }
  void add_where(Utterance& out, std::uint32_t floor, std::uint32_t room) const;
  void add_detail(Utterance& out, const Control& control) const;
  void add_list(Utterance& out) const;
  void add_search(Utterance& out) const;
  void add_walk(Utterance& out) const;
  void add_arrival(Utterance& out) const;
  void add_picture(Utterance& out, const ShownPicture& picture) const;
  void add_tour(Utterance& out) const;
  std::string count(std::string_view key, std::size_t n, std::size_t total) const;
  std::string_view goal_title() const;
  std::string refusal() const;

  const Museum& museum_;
  const ViewRequest& request_;
  const InterfaceState& state_;
  const Closures& closed_;
  const ShownWay* way_;
  std::uint32_t language_;
};

/// "2 of 5".
std::string Composer::count(std::string_view key, std::size_t n, std::size_t total) const {
  const std::string text = filled_in(say(key), "n", apart(fmt::format("{}", n)));
  return filled_in(text, "total", apart(fmt::format("{}", total)));
}

void Composer::add_where(Utterance& out, std::uint32_t floor, std::uint32_t room) const {
  if (room < museum_.rooms.size()) append_spoken(out, local(museum_.rooms[room].title));
  if (floor != museum_.kiosk_floor && floor < museum_.floors.size())
    append_spoken(out, local(museum_.floors[floor].title));
}

/// What tells one of a list from another: which exhibit it collects, where it is, how long it
/// takes, that it is closed.
void Composer::add_detail(Utterance& out, const Control& control) const {
  const Action& action = control.action;
  if (is_collect(control) && action.argument < museum_.exhibits.size())
    return append_spoken(out, local(museum_.exhibits[action.argument].title));
  if (const Tour* tour = begun_tour(museum_, control); tour != nullptr)
    return append_spoken(out, filled_in(say("tour_card"), "time",
                                        apart(spoken_time(museum_, language_, tour->seconds))));
  if (control.role != Role::ListItem && control.role != Role::Spot) return;
  switch (action.kind) {
    case Action::Kind::FollowTour:
    case Action::Kind::Choose: {
      if (action.argument >= museum_.exhibits.size()) return;
      if (closed_exhibit(closed_, action.argument) != nullptr)
        return append_spoken(out, say("closed_now"));
      const Exhibit& exhibit = museum_.exhibits[action.argument];
      return add_where(out, exhibit.floor, exhibit.room);
    }
    case Action::Kind::Seek: {
      const auto only = only_place(museum_, static_cast<PlaceKind>(action.argument));
      if (!only) return;
      const Place& place = museum_.places[*only];
      return add_where(out, place.floor, room_of(museum_, place.floor, place.position));
    }
    case Action::Kind::Browse:
      return append_spoken(out, say(group_of(museum_, action.argument).kind));
    case Action::Kind::GoToPlace: {
      if (control.role == Role::Spot || action.argument >= museum_.places.size()) return;
      const Place& place = museum_.places[action.argument];
      return add_where(out, place.floor, room_of(museum_, place.floor, place.position));
    }
    default:
      return;
  }
}

/// What a key is called.
std::string Composer::said_key(std::uint32_t letter) const {
  return letter == U' ' ? std::string(say("key_space")) : said_of(static_cast<char16_t>(letter));
}

/// Else it was typed in another language.
bool Composer::is_on_keyboard(char16_t letter) const {
  const Keyboard& keyboard = keyboard_of(
      language_ < museum_.languages.size() ? museum_.languages[language_].tag : std::string());
  return letter == u' ' || digit_keys.find(letter) != digit_keys.npos ||
         std::ranges::any_of(keyboard.rows,
                             [&](std::u16string_view row) { return row.find(letter) != row.npos; });
}

/// The letter that was typed last, and how many things are found; or what one can type.
void Composer::add_search(Utterance& out) const {
  if (state_.typed.count == 0) {
    if (state_.browses) return append_spoken(out, local(*group_of(museum_, *state_.browses).title));
    append_spoken(out, say("search"));
    append_spoken(out, say("search_hint"));
    if (state_.found.count > 0) append_spoken(out, say("search_browse"));
    return;
  }
  const char16_t last = state_.typed.letters().back();
  if (is_on_keyboard(last)) append_spoken(out, said_key(last));
  if (!state_.found.is_current) return;
  if (state_.found.total == 0) return append_spoken(out, say("search_none"));
  // So many numbers are prepared.
  const std::size_t most = museum_.exhibits.size() + museum_.tours.size();
  const std::size_t total =
      std::min<std::size_t>(state_.found.total, std::max<std::size_t>(most, 20));
  append_spoken(out, filled_in(say("search_found"), "n", apart(fmt::format("{}", total))));
}

/// "Listen", and what to.
void Composer::add_sound(Utterance& out, const Action& action) const {
  const std::string_view key = action.kind == Action::Kind::PlaySound ? "sound_play" : "sound_stop";
  if (!state_.exhibit || *state_.exhibit >= museum_.exhibits.size()) return;
  const auto sounds = sounds_of(museum_, *state_.exhibit);
  if (action.argument >= sounds.size()) return;
  std::string text = filled_in(say(key), "title", apart(local(sounds[action.argument].title)));
  std::ranges::replace(text, between_pieces, '\n');
  append_paragraphs(out, text);
}

/// Who cannot read a language's name hears it in that language.
Utterance Composer::control(const Control& control) const {
  const bool names_language = control.action.kind == Action::Kind::Speak;
  const std::uint32_t language = names_language ? control.action.argument : language_;
  Utterance out = begun_in(language);
  const std::string_view label = control.name == "begin"       ? say("say_begin")
                                 : control.name == "stay"      ? say("say_stay")
                                 : control.name == "languages" ? say("languages_title")
                                                               : local(control.label);
  const Tour* tour = begun_tour(museum_, control);
  if (tour != nullptr)
    append_spoken(out, title_in(museum_, language_, *tour, Digits::Plain));
  else if (control.action.kind == Action::Kind::Type)
    append_spoken(out, said_key(control.action.argument));
  else if (is_of_sound(control.action))
    add_sound(out, control.action);
  else
    append_spoken(out, label);
  if (!names_language) add_detail(out, control);
  const auto says = [&](std::string_view key) { append_spoken(out, word(museum_, language, key)); };
  says(role_word(control.role));
  if (control.selected) says("state_selected");
  if (!control.enabled) says("state_disabled");
  return out;
}

void Composer::add_list(Utterance& out) const {
  append_spoken(out, say(title_of(state_.lists)));
  const std::uint32_t per_page = exhibits_per_page(request_.shape, state_);
  const std::uint32_t pages = page_count(museum_, state_, per_page);
  if (pages > 1) append_spoken(out, count("page_of", std::min(state_.page, pages - 1) + 1, pages));
}

std::string_view Composer::goal_title() const {
  if (state_.exhibit && *state_.exhibit < museum_.exhibits.size())
    return local(museum_.exhibits[*state_.exhibit].title);
  std::optional<PlaceKind> kind = state_.seeks;
  if (state_.place && *state_.place < museum_.places.size()) {
    const Place& place = museum_.places[*state_.place];
    if (!place.title.empty()) return local(place.title);
    kind = place.kind;
  }
  return kind ? say(word_of(*kind)) : std::string_view{};
}

/// Why there is no way.
std::string Composer::refusal() const {
  const std::optional<Goal> goal = goal_of(museum_, state_);
  const std::optional<Hindrance> hindrance = request_.route_summary->hindrance;
  if (!hindrance || !goal) return std::string(say("no_way"));
  const Floor& floor = museum_.floors[goal->floor];
  const std::string_view title = local(floor.title);
  return filled_in(say(hindrance_word(*hindrance)), "floor",
                   apart(title.empty() ? std::string_view(floor.plan.short_name) : title));
}

void Composer::add_tour(Utterance& out) const {
  const std::optional<TourStops> tour = stops_of(museum_, state_.own_tour, state_.tour);
  if (!tour) return;
  append_spoken(
      out, state_.tour->tour == TourWalk::own
               ? std::string(say("own_tour"))
               : title_in(museum_, language_, museum_.tours[state_.tour->tour], Digits::Plain));
  append_spoken(out, count("page_of", state_.tour->stop + 1, tour->exhibits.size()));
  if (state_.arrived && !next_stop(museum_, state_.own_tour, state_.tour))
    append_spoken(out, say("tour_done"));
}

void Composer::add_walk(Utterance& out) const {
  add_tour(out);
  const auto& summary = request_.route_summary;
  if (summary && summary->status != path::RouteStatus::Ok) {
    append_spoken(out, goal_title());
    return append_spoken(out, refusal());
  }
  append_spoken(out, say(state_.exhibit ? "follow" : "follow_to_place"));
  append_spoken(out, goal_title());
  if (way_ == nullptr) return append_spoken(out, say("planning"));
  const WaySentences way = spoken_sentences_in(museum_, language_, way_->directions);
  for (const std::string* sentence : {&way.way, &way.goal, &way.figures})
    append_spoken(out, *sentence);
}

/// Which of several pictures is seen, and what it shows.
void Composer::add_picture(Utterance& out, const ShownPicture& picture) const {
  if (picture.count > 1) append_spoken(out, count("picture_of", picture.number, picture.count));
  if (picture.caption != nullptr) append_spoken(out, local(*picture.caption));
  append_spoken(out, local(*picture.description));
}

void Composer::add_arrival(Utterance& out) const {
  if (reads_more(museum_, state_)) {
    append_spoken(out, goal_title());
    return append_paragraphs(out, local(museum_.exhibits[*state_.exhibit].more));
  }
  if (state_.picture && state_.exhibit && *state_.exhibit < museum_.exhibits.size() &&
      picture_count(museum_, *state_.exhibit) > 1)
    return add_picture(out, shown_picture(museum_, state_, *state_.exhibit));
  add_tour(out);
  append_spoken(out, goal_title());
  if (state_.exhibit && *state_.exhibit < museum_.exhibits.size()) {
    const Exhibit& exhibit = museum_.exhibits[*state_.exhibit];
    if (closed_exhibit(closed_, *state_.exhibit) != nullptr)
      append_spoken(out, say("closed_now"));
    else if (may_be_touched(exhibit.place))
      append_spoken(out, say("may_touch"));
    add_picture(out, shown_picture(museum_, state_, *state_.exhibit));
    return append_spoken(out, local(exhibit.text));
  }
  if (const std::optional<Goal> goal = goal_of(museum_, state_))
    add_where(out, goal->floor, room_of(museum_, goal->floor, goal->position));
}

Utterance Composer::opening() const {
  Utterance out = begun_in(language_);
  if (state_.asks_to_stay) {
    append_spoken(out, say("still_here"));
    return out;
  }
  switch (state_.screen) {
    case Screen::Welcome:
      append_spoken(out, local(museum_.title));
      append_spoken(out, say("welcome"));
      append_spoken(out, say("help_keys"));
      break;
    case Screen::Picking:
      break;  // of a shared glass, which does not speak
    case Screen::Choosing:
      add_list(out);
      break;
    case Screen::Walking:
      add_walk(out);
      break;
    case Screen::Arrived:
      add_arrival(out);
      break;
    case Screen::Searching:
      add_search(out);
      break;
  }
  return out;
}

Utterance Composer::help() const {
  Utterance out = begun_in(language_);
  switch (state_.screen) {
    case Screen::Welcome:
      append_spoken(out, say("help_welcome"));
      break;
    case Screen::Picking:
      break;
    case Screen::Choosing:
      append_spoken(out, say("help_choosing"));
      add_list(out);
      break;
    case Screen::Walking:
      append_spoken(out, say("help_walking"));
      append_spoken(out, goal_title());
      break;
    case Screen::Searching:
      append_spoken(out, say("help_searching"));
      break;
    case Screen::Arrived:
      append_spoken(out, say("help_arrived"));
      append_spoken(out, goal_title());
      break;
  }
  append_spoken(out, say("help_keys"));
  return out;
}

std::vector<CountedUtterance> Composer::remaining() const {
  std::vector<CountedUtterance> all;
  if (state_.screen != Screen::Walking || way_ == nullptr) return all;
  for (const float metres : milestones)
    if (static_cast<double>(metres) < way_->directions.metres)
      all.push_back({metres, said(filled_in(say("remaining"), "distance",
                                            apart(spoken_distance(museum_, language_,
                                                                  static_cast<double>(metres)))))});
  all.push_back({2, said(say("nearly_there"))});
  return all;
}

}  // namespace

const Utterance* said_in(const Speech& speech, const SpeechPart& part) noexcept {
  using Kind = SpeechPart::Kind;
  const auto at = [&](const auto& all) {
    return part.index < all.size() ? &all[part.index] : nullptr;
  };
  switch (part.kind) {
    case Kind::Nothing:
    case Kind::Silence:
      return nullptr;
    case Kind::Opening:
      return &speech.opening;
    case Kind::Help:
      return &speech.help;
    case Kind::Control:
      return at(speech.controls);
    case Kind::Remaining:
      return part.index < speech.remaining.size() ? &speech.remaining[part.index].said : nullptr;
    case Kind::Volume:
      return at(speech.volumes);
    case Kind::Speed:
      return at(speech.speeds);
    case Kind::Ended:
      return &speech.ended;
  }
  return nullptr;
}

Speech speech_of(const Museum& museum, const ViewRequest& request,
                 const std::vector<Control>& controls, const Closures& closed,
                 const ShownWay* way) {
  const Composer composer(museum, request, closed, way);
  Speech speech;
  speech.opening = composer.opening();
  speech.help = composer.help();
  const InterfaceState& state = request.state;
  speech.keeps_focus =
      (state.screen == Screen::Searching && state.typed.count > 0) ||
      (state.screen == Screen::Arrived && state.picture && !reads_more(museum, state));
  for (const Control& control : controls) speech.controls.push_back(composer.control(control));
  speech.remaining = composer.remaining();
  for (std::size_t i = 0; i < speech.volumes.size(); ++i)
    speech.volumes[i] =
        composer.said(filled_in(composer.say("volume"), "n", apart(fmt::format("{}", i))));
  constexpr std::array<std::string_view, speech_speeds.size()> speeds{
      "speed_slower", "speed_normal", "speed_faster", "speed_fastest"};
  for (std::size_t i = 0; i < speeds.size(); ++i)
    speech.speeds[i] = composer.said(composer.say(speeds[i]));
  speech.ended = composer.said(composer.say("speech_off"));
  for (Utterance* one : {&speech.opening, &speech.help, &speech.ended}) time_pieces(*one, museum);
  for (Utterance& one : speech.controls) time_pieces(one, museum);
  for (CountedUtterance& one : speech.remaining) time_pieces(one.said, museum);
  for (Utterance& one : speech.volumes) time_pieces(one, museum);
  for (Utterance& one : speech.speeds) time_pieces(one, museum);
  return speech;
}

}  // namespace docent::interface
