#include "runtime/kiosk/visit_player.h"
#include "runtime/guide/label_placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "runtime/scene/side.h"

namespace docent::kiosk {
namespace {

constexpr double tap_seconds = 0.1;  ///< How long a tap's finger stays down.
constexpr std::size_t most_touches = 3;
constexpr std::size_t most_touches_at_seat = 10;   ///< Its list has small pages.
constexpr std::uint32_t first_tap_finger = 10000;  ///< Apart from the fingers that visits number.

/// The control of that name on the screen: a card before a spot.
const interface::Control* on_screen(const interface::View& view, const interface::Control& wanted) {
  const auto found = std::ranges::find_if(view.controls, [&](const interface::Control& c) {
    return c.name == wanted.name && c.enabled && c.rect.width > 0 && c.role == wanted.role;
  });
  return found == view.controls.end() ? nullptr : &*found;
}

/// What stands for that control, which is in its cluster.
const interface::Control* head_on(const interface::View& view, const interface::Control& wanted) {
  for (std::size_t i = 0; i < view.controls.size(); ++i) {
    const interface::Control& control = view.controls[i];
    if (control.name != wanted.name || control.role != wanted.role) continue;
    const std::int32_t head = guide::head_of(view, static_cast<std::int32_t>(i));
    if (head >= 0) return &view.controls[static_cast<std::size_t>(head)];
  }
  return nullptr;
}

/// Is that control of the cluster that is open, which has no room for it?
bool is_crowded_out(const interface::View& view, const interface::Control& wanted) {
  if (view.open < 0 || view.cluster.width <= 0) return false;
  return std::ranges::any_of(view.labels, [&](const interface::FloorLabel& label) {
    if (label.control < 0 || label.head != view.open) return false;
    const interface::Control& control = view.controls[static_cast<std::size_t>(label.control)];
    return control.name == wanted.name && control.role == wanted.role;
  });
}

/// What turns the part that scrolls towards that control, where it lies there and is not seen.
const interface::Control* turner_to(const interface::View& view, const interface::Control& wanted) {
  const interface::ScrollArea& area = view.scroll;
  for (const interface::ScrollArea::Scrolled& one : area.controls) {
    const interface::Control& control = view.controls[static_cast<std::size_t>(one.control)];
    if (control.name != wanted.name || control.role != wanted.role) continue;
    for (const std::int32_t turner : {area.down, area.up})
      if (turner >= 0 && view.controls[static_cast<std::size_t>(turner)].enabled)
        return &view.controls[static_cast<std::size_t>(turner)];
  }
  return nullptr;
}

}  // namespace

bool VisitPlayer::is_over() const noexcept {
  return quit_ || (next_ == visit_.commands.size() && named_.empty() && lifts_.empty());
}

Result<void> VisitPlayer::play(double time, const guide::Guide& guide, const TakeEvent& take) {
  constexpr double tolerance = 1e-9;
  std::erase_if(lifts_, [&](const Lift& lift) {
    if (lift.time > time + tolerance) return false;
    take({.kind = input::InputEvent::Kind::Up, .contact = lift.contact});
    return true;
  });
  while (next_ < visit_.commands.size() && visit_.commands[next_].time <= time + tolerance &&
         !quit_)
    play(visit_.commands[next_++], time, take);
  return continue_named_tap(time, guide, take);
}

void VisitPlayer::play(const VisitCommand& command, double time, const TakeEvent& take) {
  using Kind = VisitCommand::Kind;
  switch (command.kind) {
    case Kind::Tap:
      return tap(command.contact.x, command.contact.y, time, take);
    case Kind::TapNamed:
      return named_.push_back(command);
    case Kind::Down:
      return take({.kind = input::InputEvent::Kind::Down, .contact = command.contact});
    case Kind::Move:
      return take({.kind = input::InputEvent::Kind::Move, .contact = command.contact});
    case Kind::Up:
      return take({.kind = input::InputEvent::Kind::Up, .contact = command.contact});
    case Kind::Press: {
      input::InputEvent key = command.key;
      take(key);
      key.kind = input::InputEvent::Kind::KeyUp;
      return take(key);
    }
    case Kind::Shot:
      return shots_.push_back(command.name);
    case Kind::Controls:
      return lists_.push_back(command.name);
    case Kind::Today:
      return todays_.push_back(command.name);
    case Kind::Headphones:
      headphones_ = command.name == "in";
      return;
    case Kind::Quit:
      quit_ = true;
  }
}

void VisitPlayer::tap(float x, float y, double time, const TakeEvent& take) {
  const input::Contact contact{first_tap_finger + fingers_++, x, y};
  take({.kind = input::InputEvent::Kind::Down, .contact = contact});
  lifts_.push_back({time + tap_seconds, contact});
}

/// One touch at a time, each when the last one's view is on the screen.
Result<void> VisitPlayer::continue_named_tap(double time, const guide::Guide& guide,
                                             const TakeEvent& take) {
  if (named_.empty() || !lifts_.empty()) return {};
  const VisitCommand& wanted = named_.front();
  if (wanted.seat && *wanted.seat > guide.seats())
    return std::unexpected(
        Error{Errc::InvalidInput, fmt::format("line {}: this glass has {} seats, and no seat {}",
                                              wanted.line, guide.seats(), *wanted.seat)});
  if (guide.is_attracting()) {  // whoever comes touches it first, to see what there is
    tap(0.5F, 0.5F, time, take);
    return {};
  }
  const std::size_t part = guide.part_of(wanted.seat);
  if (!guide.shows_its_state(part)) return {};
  const interface::InterfaceState& state = guide.state(part);
  const auto tap_on = [&](const interface::Control& it) {
    const scene::Rect at = scene::to_screen(guide.view(part)->side, it.rect);
    tap(at.x + at.width / 2, at.y + at.height / 2, time, take);
  };
  if (interface::turns_what_scrolls(wanted.name)) {  // of a view alone, and not of a state
    const auto& controls = guide.view(part)->controls;
    const auto turner = std::ranges::find(controls, wanted.name, &interface::Control::name);
    if (turner == controls.end())
      return std::unexpected(
          Error{Errc::InvalidInput,
                fmt::format("line {}: nothing scrolls here, so there is no '@{}' to touch",
                            wanted.line, wanted.name)});
    tap_on(*turner);
    named_.pop_front();
    return {};
  }
  const std::size_t most = part == 0 ? most_touches : most_touches_at_seat;
  const std::vector<interface::Control> touches = interface::touches_to(
      guide.museum(), state, interface::exhibits_per_page(guide.shape(), state), wanted.name, most);
  if (touches.empty())
    return std::unexpected(
        Error{Errc::InvalidInput,
              fmt::format("line {}: no visitor could touch '@{}' within {} touches from here",
                          wanted.line, wanted.name, most)});
  const interface::Control* control = on_screen(*guide.view(part), touches.front());
  if (control == nullptr) {
    if (const interface::Control* turner = turner_to(*guide.view(part), touches.front());
        turner != nullptr && !guide.is_scrolling(part))
      tap_on(*turner);
    else if (const interface::Control* head = head_on(*guide.view(part), touches.front());
             head != nullptr && guide.is_settled(part))
      tap_on(*head);
    else if (is_crowded_out(*guide.view(part), touches.front()))
      return std::unexpected(
          Error{Errc::InvalidInput,
                fmt::format("line {}: '@{}' lies among others, and there is no room to show it",
                            wanted.line, wanted.name)});
    return {};
  }
  const interface::View& shown = *guide.view(part);
  if (shown.open >= 0 && shown.cluster.width <= 0) return {};  // it opens in this frame
  if (guide.is_scrolling(part)) return {};  // a finger would stop it, and press nothing
  // Spots stand still only when the camera does.
  if (control->role == interface::Role::Spot && !guide.is_settled(part)) return {};
  tap_on(*control);
  const auto index = static_cast<std::int32_t>(control - shown.controls.data());
  // A cluster opens first, and shows it at a place of its own.
  if (touches.size() == 1 && !guide::stands_for_several(shown, index)) named_.pop_front();
  return {};
}

std::vector<Diagnostic> unknown_names(const Museum& museum, const Visit& visit,
                                      std::string_view file) {
  std::vector<Diagnostic> mistakes;
  for (const VisitCommand& command : visit.commands)
    if (command.kind == VisitCommand::Kind::TapNamed &&
        !interface::is_control_name(museum, command.name))
      mistakes.push_back(
          {.file = std::string(file),
           .line = command.line,
           .code = "unknown-control",
           .message = fmt::format("no screen of this museum has a control '@{}'", command.name),
           .hint = fmt::format(
               "names are @exhibit:ID, @place:KIND, @spot:ID, @tour:ID, @route:{}, @language:TAG, "
               "@search, @key:LETTER, @key:space, @key:erase, @key:clear, @key:numbers, "
               "@collect:ID, @own-tour, @start-tour, @times, @toilets, @places, @exhibits, "
               "@step-free, "
               "@no-escalators, @speak, @larger, @contrast, @lower, @home, @stop, @begin, "
               "@choose, @back, @text-up, @text-down and @look:NAME",
               fmt::join(route_kinds | std::views::transform(&RouteKindInfo::name), "|"))});
  return mistakes;
}

}  // namespace docent::kiosk
