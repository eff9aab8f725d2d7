#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/tour_walk.h"
#include "runtime/interface/typed.h"
#include "runtime/model/museum.h"
#include "runtime/model/place_kind.h"
#include "runtime/model/route_kind.h"
#include "runtime/path/building/building_way.h"
#include "runtime/scene/draw_list.h"

namespace docent::interface {

/// The screens that the kiosk can show.
enum class Screen : std::uint8_t {
  Welcome,    ///< The whole model and a greeting. At a seat: nobody is there.
  Picking,    ///< The guides, of whom a visitor at a shared glass picks one.
  Choosing,   ///< The model, its exhibits marked, and the list of them.
  Walking,    ///< Behind the guide.
  Arrived,    ///< Beside the guide, in front of the exhibit.
  Searching,  ///< The model, a keyboard on it, and what was found.
};

/// Who uses the glass. On a shared glass every visitor has a seat with a card at the lower edge;
/// the rest of the glass, the model, belongs to all of them.
enum class Glass : std::uint8_t {
  Whole,       ///< One visitor, who has all of it.
  Quiet,       ///< Shared; nobody is there.
  Busy,        ///< Shared; somebody is there, and there is room for more.
  Full,        ///< Shared; every seat is taken.
  TurnedAway,  ///< Shared and full; somebody has just asked for a seat in vain.
};

/// What the list of the choosing screen holds, or that of the searching one.
enum class Listed : std::uint8_t {
  Exhibits,  ///< Below the tours.
  Places,
  OwnTour,    ///< What the visitor has collected, in the order of the walk.
  Languages,  ///< Where there are too many to stand beside each other.
  Found,      ///< What the typed letters find.
  Times,      ///< Tours by the time that one has.
};

/// What comes next on a walk.
enum class Chapter : std::uint8_t { Room, Floor, Goal };

/// The part of the guide's state that decides which controls there are and what they say. The rest
/// (where the avatar is, how far a blend has come) only moves things.
struct InterfaceState {
  Screen screen = Screen::Welcome;
  std::uint32_t language = 0;                  ///< Index into Museum::languages.
  std::uint32_t page = 0;                      ///< Of the list, on the choosing screen.
  Listed lists = Listed::Exhibits;             ///< What that list holds.
  std::optional<std::uint32_t> floor{};        ///< That is seen from above; none: the kiosk's.
  std::optional<std::uint32_t> guide_floor{};  ///< Where the guide leads; none: likewise.
  /// Where the visitor is going or has arrived: an exhibit or a place.
  std::optional<std::uint32_t> exhibit{};
  std::optional<PlaceKind> seeks{};  ///< They want the nearest place of that kind, ...
  /// ... which is this one, once that has been found out; or they chose this one on the model.
  std::optional<std::uint32_t> place{};
  /// Which of the exhibit's pictures is seen, once they have leafed through them.
  std::optional<std::uint8_t> picture{};
  bool plays = false;       ///< That picture, which is a video.
  bool tells_more = false;  ///< Its longer text is read.
  /// Which of the exhibit's sounds they listen to.
  std::optional<std::uint8_t> sound{};
  bool can_sound = false;  ///< There is something to hear it with.
  RouteKind kind = RouteKind::Shortest;
  RouteKind usual_kind = RouteKind::Shortest;  ///< Until a visitor chooses another.
  path::Permissions ways{};  ///< Without steps, without escalators; until the visitor leaves.
  bool arrived = false;      ///< The guide stands there.
  Glass glass = Glass::Whole;
  std::uint8_t seats = 0;  ///< How many a shared glass has.
  /// The seat whose card this is, counted from the left, from 1; none: no card, but the model.
  std::optional<std::uint32_t> seat{};
  std::optional<std::uint32_t> look{};  ///< Index into `looks`: the guide that was picked.
  std::uint8_t taken = 0;               ///< A bit for each guide that others have.
  std::optional<TourWalk> tour{};       ///< The tour on which the visitor goes to `exhibit`.
  OwnTour own_tour{};                   ///< What they have collected; until they leave.
  Typed typed{};                        ///< What they search for; until they leave.
  Found found{};
  /// A gallery, a subject or a period whose exhibits they look through, as an entry (finder.h).
  std::optional<std::uint32_t> browses{};
  bool types_numbers = false;  ///< The keys are digits.
  bool speaks = false;         ///< What they do and may do is read aloud.
  bool large_letters = false, high_contrast = false;
  bool low_reach = false;  ///< All that can be touched lies within reach of who sits.
  bool can_lower = false;  ///< The glass hangs so that this makes a difference.
  /// How the visitor goes along on the walk: 0 not yet, they see the whole way from above; else so
  /// many times as fast as the guide walks.
  std::uint8_t pace = 0;
  Chapter next = Chapter::Goal;  ///< Who goes along comes to that next, ...
  bool skips = false;            ///< ... and goes there as fast as can be.
  bool asks_to_stay = false;     ///< They have touched nothing for long: are they still there?
  bool can_resume = false;       ///< They have started over just now, and may take that back.

  bool operator==(const InterfaceState&) const = default;
};

/// What pressing a control asks for.
struct Action {
  enum class Kind : std::uint8_t {
    Begin,            ///< From the welcome to the list of exhibits; at a seat, to the guides.
    Pick,             ///< The guide with look `argument`.
    Choose,           ///< Go to exhibit `argument`.
    FollowTour,       ///< Go to exhibit `argument`, which is `stop`.
    Seek,             ///< Go to the nearest place of the kind `argument`.
    GoToPlace,        ///< Go to place `argument`.
    TurnPage,         ///< Show page `argument` of the list.
    ShowFloor,        ///< Show floor `argument` from above.
    ShowPicture,      ///< Picture `argument` of the exhibit, from 0.
    PlayVideo,        ///< That picture, where `argument` is 1; 0: it stands still.
    PlaySound,        ///< Sound `argument` of the exhibit, from 0.
    StopSound,        ///< It is heard no more.
    TellMore,         ///< The exhibit's longer text, where `argument` is 1; 0: what one saw before.
    Speak,            ///< Language `argument`.
    TakeRoute,        ///< RouteKind `argument`.
    AvoidSteps,       ///< Ways without steps only, where `argument` is 1; 0: any.
    AvoidEscalators,  ///< The same of escalators.
    ReadAloud,        ///< What is on the glass, where `argument` is 1; 0: be silent.
    EnlargeLetters,   ///< Where `argument` is 1; 0: as usual.
    RaiseContrast,    ///< Likewise.
    Lower,            ///< Likewise: what can be touched.
    ShowExhibits,     ///< The list again; the walk goes on.
    ShowPlaces,       ///< The list of places; the walk goes on.
    ShowLanguages,    ///< The list of languages; the walk goes on.
    ShowTimes,        ///< The list of tours by time; the walk goes on.
    Collect,          ///< Exhibit `argument` into the visitor's own tour.
    Discard,          ///< Out of it again.
    ShowOwnTour,      ///< The list of what is in it; the walk goes on.
    Search,           ///< The keyboard, and what was found so far; the walk goes on.
    Type,             ///< The letter `argument`.
    Erase,            ///< The last letter.
    Browse,           ///< What belongs to the gallery, subject or period that is entry `argument`.
    Clear,            ///< All letters.
    TypeNumbers,      ///< Keys of digits, where `argument` is 1; 0: of letters.
    Return,           ///< From the list back to the walk, the exhibit or the welcome.
    GoOnward,         ///< Past what is left until the next chapter of the walk.
    Walk,             ///< Along with the guide, `argument` times as fast as it walks.
    Stop,             ///< The guide stops where it is.
    Home,             ///< Back to the welcome; the guide walks home.
    Stay,             ///< They are still there.
    Scroll,           ///< What is longer than there is room for: up where `argument` is 0, or down.
    Resume,           ///< Starting over is taken back: whoever keeps the session knows to what.
  };
  Kind kind = Kind::Begin;
  std::uint32_t argument = 0;
  TourWalk stop{};  ///< Of FollowTour.
};

/// The state after an action: the one rule that touch, keypad, named taps and tests share.
InterfaceState after(InterfaceState state, Action action) noexcept;

enum class Role : std::uint8_t {
  Button,
  ListItem,  ///< An exhibit or a kind of place on a card.
  Spot,      ///< An exhibit or a place where it is on the model.
  Choice,    ///< One of several of which one holds: language, route kind.
};

/// Something a visitor can press. One list per view: drawing, touch, keypad, scripted visits and
/// tests all read it.
struct Control {
  /// Stable, the same in every language: `exhibit:ID`, `collect:ID`, `place:KIND`, `tour:ID`,
  /// `search`, `key:LETTER`, `gallery:ID`,
  /// `subject:ID` and `period:ID` (of the first exhibit that has it), `next`, `route:shortest`,
  /// `sound:NUMBER` (from 1), `language:TAG`, `home`... A spot bears its exhibit's name; a list
  /// item of that name, where there is one, comes first. A place on the model is `spot:ID`.
  std::string name;
  Role role = Role::Button;
  LocalText label;
  Action action;
  bool selected = false;
  bool enabled = true;
  scene::Rect
      rect;  ///< Screen frame. A spot's follows the camera; empty while it is out of the picture.
};

/// The tour that a control begins; null where it begins none that the museum has.
const Tour* begun_tour(const Museum& museum, const Control& control) noexcept;

/// So many languages have room for their names beside each other, on every screen. More are on the
/// welcome screen, in rows, and behind one button.
inline constexpr std::size_t most_languages_beside = 5;

/// Are exhibits and places touched on the model while this screen is shown?
constexpr bool shows_spots(Screen screen) noexcept {
  return screen == Screen::Welcome || screen == Screen::Choosing;
}

/// Times as fast as the guide walks.
inline constexpr std::uint32_t fastest_pace = 4;

/// Is the way seen from above as a whole, as it is until the visitor goes along?
constexpr bool shows_whole_way(const InterfaceState& state) noexcept {
  return state.screen == Screen::Walking && state.glass == Glass::Whole && state.pace == 0;
}

/// Does it type, or take back what was typed?
bool is_key(const Control& control) noexcept;
/// Does it put an exhibit into the visitor's own tour, or take it out?
bool is_collect(const Control& control) noexcept;

/// The controls of a state in focus order, without their rectangles. `per_page` is how many
/// exhibits a page of the list shows. What is on every screen follows what is the screen's own;
/// spots come last.
std::vector<Control> controls_of(const Museum& museum, const InterfaceState& state,
                                 std::uint32_t per_page);

/// The choice of a kind of route: one control each, in the order of the table.
std::vector<Control> route_controls(const Museum& museum, RouteKind selected,
                                    std::span<const RouteKindInfo> kinds = route_kinds);

/// The floors by their ordinals, the highest first.
std::vector<std::uint32_t> floors_from_above(const Museum& museum);

/// Exhibits that could follow the one at `exhibit`: the nearest on the same floor by straight line
/// between viewing points, nearest first.
std::vector<std::uint32_t> neighbours(const Museum& museum, std::uint32_t exhibit,
                                      std::size_t count);

/// How many suggestions the arrived screen makes.
inline constexpr std::size_t suggestion_count = 2;

/// How many pages the list has: that of tours and exhibits, or that of places; at least 1.
std::uint32_t page_count(const Museum& museum, const InterfaceState& state,
                         std::uint32_t per_page) noexcept;

/// The controls that a visitor in `state` has to touch to press the control `name`, that one
/// included; empty where more than `most` touches would be needed. List items are preferred to
/// spots: pages are turned where few enough touches do it.
std::vector<Control> touches_to(const Museum& museum, const InterfaceState& state,
                                std::uint32_t per_page, std::string_view name,
                                std::size_t most = 3);

/// Is it one of the two that turn what is longer than there is room for? They are in no
/// controls_of(): whether there is anything to turn is found out when a view is laid out.
constexpr bool turns_what_scrolls(std::string_view name) noexcept {
  return name == "text-up" || name == "text-down";
}

/// Does any view of this museum have a control of that name?
bool is_control_name(const Museum& museum, std::string_view name);

/// The interface's text for `key` in a language: falls back to the first language, then to `key`.
std::string_view word(const Museum& museum, std::uint32_t language, std::string_view key) noexcept;
/// BCP 47; empty where the museum has no such language.
std::string_view language_tag(const Museum& museum, std::uint32_t language) noexcept;
/// `text` in a language, with the same fallbacks; empty where there is none at all.
std::string_view in_language(const Museum& museum, std::uint32_t language,
                             const LocalText& text) noexcept;

}  // namespace docent::interface
