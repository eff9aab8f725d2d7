#include "runtime/guide/guide.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/guide/waiting_places.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"

namespace docent::guide {
namespace {

constexpr std::size_t most_ribbon_points = 4096, most_quads = 1024, most_markers = 512;
constexpr std::size_t points_of_a_trail = 1024;
constexpr std::size_t quads_of_a_card = 256;
constexpr std::size_t most_contacts = 80;
constexpr double guide_rank = 100;      ///< Visitors on their own make room for a guide.
constexpr float arms_reach = 600;       ///< Millimetres of glass that one visitor covers.
constexpr float reach_up = 0.3F;        ///< Of a millimetre upwards, what it counts to the side.
constexpr float refusal_shown_for = 8;  ///< Seconds.
constexpr float strays_columns = 1.5F;  ///< A territory that far from its card draws it along.

std::size_t guides_on(const GuideSettings& settings) noexcept {
  return interface::seats_on(settings.shape, settings.visitors) > 1 ? scene::guide_look_count : 1;
}

}  // namespace

PlannerSize planner_size(const Museum& museum, const GuideSettings& settings) noexcept {
  const std::size_t seats = interface::seats_on(settings.shape, settings.visitors);
  return {guides_on(settings) + museum.ambient.count, seats > 1 ? 1 + seats : 1};
}

Guide::Guide(const Museum& museum, plan::Planner& planner, const GuideSettings& settings)
    : museum_(museum),
      planner_(planner),
      settings_(settings),
      crowd_(museum, planner),
      strollers_(museum),
      stage_(museum) {
  enter_guides();
  strollers_.enter(crowd_);
  take_seats();
  list_.avatars.reserve(crowd_.size());
  list_.palette.reserve(crowd_.size() * leader().world.size());
  const auto guides =
      static_cast<std::size_t>(std::ranges::count_if(crowd_.members(), leaves_a_trail));
  list_.ribbons.reserve(guides);
  list_.ribbon_point.reserve(most_ribbon_points + (guides - 1) * points_of_a_trail);
  list_.markers.reserve(std::max(most_markers, museum.exhibits.size() + 8) +
                        2 * interface::most_seats);
  list_.quads.reserve(std::max(most_quads, museum.exhibits.size() * 4 + 512) +
                      sessions_.size() * quads_of_a_card);
}

/// Guides wait near the kiosk, as many as there is room for.
void Guide::enter_guides() {
  const std::size_t wanted = guides_on(settings_);
  homes_ = {museum_.kiosk};
  if (wanted > 1 && museum_.kiosk_floor < planner_.maps().size()) {
    std::vector<Vec2> keep_clear = museum_.ambient.entrances;
    for (const Exhibit& exhibit : museum_.exhibits)
      if (exhibit.floor == museum_.kiosk_floor)
        keep_clear.push_back(exhibit.viewing_point.position);
    homes_ = waiting_places(*planner_.maps()[museum_.kiosk_floor], museum_.kiosk, wanted,
                            museum_.body_radius, keep_clear);
  }
  for (const Placement& home : homes_) {
    const std::uint32_t who = crowd_.add(museum_.kiosk_floor, home, guide_rank, 1);
    crowd_.set_look(who, who);
  }
}

/// One visitor has the whole glass; several have a seat each, and a guide as soon as they pick one.
void Guide::take_seats() {
  const std::size_t seats = std::min<std::size_t>(
      interface::seats_on(settings_.shape, settings_.visitors), homes_.size());
  const SessionContext context{museum_, planner_, crowd_, settings_.shape, homes_};
  const bool shared = seats > 1;
  sessions_.reserve(shared ? 1 + seats : 1);
  interface::InterfaceState state;
  state.glass = shared ? interface::Glass::Quiet : interface::Glass::Whole;
  state.seats = shared ? static_cast<std::uint8_t>(seats) : 0;
  sessions_.emplace_back(context, 0, state,
                         shared ? std::nullopt : std::optional<std::uint32_t>(0));
  for (std::size_t seat = 0; shared && seat < seats; ++seat) {
    state.seat = static_cast<std::uint32_t>(seat + 1);
    sessions_.emplace_back(context, static_cast<std::uint32_t>(seat + 1), state, std::nullopt);
  }
  territory_.resize(sessions_.size());
  held_.reserve(most_contacts);
  led_visitors_.reserve(sessions_.size());
  speaker_ = shared ? 1 : 0;
}

std::size_t Guide::part_of(std::optional<std::uint32_t> seat) const noexcept {
  for (std::size_t part = 1; seat && part < sessions_.size(); ++part)
    if (sessions_[part].state().seat == seat) return part;
  return speaker_;
}

bool Guide::shows_its_state(std::size_t part) const noexcept {
  return sessions_[part].shows_its_state();
}

bool Guide::is_settled(std::size_t part) const noexcept {
  return shows_its_state(part) && !sessions_[part].overlay().is_fading() && !stage_.is_flying();
}

bool Guide::is_vacant() const noexcept {
  return std::ranges::all_of(sessions_, &Session::is_vacant);
}

AvatarState Guide::state_of(std::uint32_t who) const noexcept {
  const Agent& one = crowd_[who];
  switch (one.avatar.gait) {
    case motion::Gait::Turn:
      return AvatarState::Turn;
    case motion::Gait::Walk:
      return AvatarState::Walk;
    case motion::Gait::Idle:
      break;
  }
  if (one.goal && !one.has_arrived) return AvatarState::Wait;
  const auto session = std::ranges::find(sessions_, std::optional(who), &Session::guide);
  const bool is_guide = who < homes_.size();
  const bool at_exhibit =
      is_guide ? session != sessions_.end() && session->state().arrived : one.goal.has_value();
  return at_exhibit ? AvatarState::Look : AvatarState::Idle;
}

// Who touches what.

void Guide::touch(const input::InputEvent& event) noexcept {
  switch (event.kind) {
    case input::InputEvent::Kind::KeyUp:
      return;
    case input::InputEvent::Kind::KeyDown:
      if (sessions_[speaker_].is_vacant()) territory_[speaker_] = middle_of_card(speaker_);
      sessions_[speaker_].press_key(event.key);
      return tell_each_other();
    case input::InputEvent::Kind::Down:
      put_down(event);
      break;
    case input::InputEvent::Kind::Move:
    case input::InputEvent::Kind::Up:
      break;
  }
  const auto held = std::ranges::find(held_, event.contact.id, &Held::contact);
  if (held == held_.end()) return;
  const Held finger = *held;
  if (event.kind == input::InputEvent::Kind::Up) held_.erase(held);
  const bool meant = sessions_[finger.visitor].touch(event, sessions_[finger.surface].overlay());
  // Perhaps somebody who found no seat.
  if (!meant && finger.surface == 0 && state().glass == interface::Glass::Full)
    refusal_seconds_ = refusal_shown_for;
  tell_each_other();
}

/// Each contact belongs to the visitor nearest to it.
void Guide::put_down(const input::InputEvent& event) noexcept {
  ++counters_.touches;
  const scene::ScreenPoint at{event.contact.x, event.contact.y};
  std::erase_if(held_, [&](const Held& held) { return held.contact == event.contact.id; });
  if (held_.size() == held_.capacity()) return;
  if (!is_shared()) {
    held_.push_back({event.contact.id, 0, 0});
    return;
  }
  const std::size_t visitor = visitor_at(at);
  if (visitor == 0) {
    refusal_seconds_ = refusal_shown_for;
    Overlay& model = sessions_[0].overlay();
    model.touch_down({event.contact, event.contact, 0});
    model.touch_up({event.contact, event.contact, 0});  // a ring, and nothing else
    return;
  }
  const bool on_model = at.y < interface::strip_of(settings_.shape).y;
  speaker_ = visitor;
  scene::ScreenPoint& territory = territory_[visitor];
  territory = sessions_[visitor].is_vacant() ? at
                                             : scene::ScreenPoint{std::midpoint(territory.x, at.x),
                                                                  std::midpoint(territory.y, at.y)};
  if (on_model) follow_territory(visitor);
  held_.push_back({event.contact.id, visitor, on_model ? 0 : visitor});
}

/// The part whose visitor touches there; 0 where that is somebody for whom there is no seat.
std::size_t Guide::visitor_at(scene::ScreenPoint at) const noexcept {
  if (at.y >= interface::strip_of(settings_.shape).y) return seat_at(at.x);
  std::size_t nearest = 0;
  const std::size_t vacant = vacant_seat_near(at.x);
  float distance = vacant > 0 ? std::min(arms_reach, 2 * column_millimetres()) : arms_reach;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float mm = millimetres(territory_[part], at);
    if (sessions_[part].is_vacant() || mm > distance) continue;
    distance = mm;
    nearest = part;
  }
  return nearest > 0 ? nearest : vacant;
}

std::size_t Guide::seat_at(float x) const noexcept {
  const auto seats = static_cast<float>(this->seats());
  const auto seat = static_cast<std::uint32_t>(std::clamp(x * seats, 0.0F, seats - 1));
  return part_of(seat + 1);
}

/// From the left edge to the middle of its seat, in seats' widths.
float Guide::column_middle(std::size_t part) const noexcept {
  return static_cast<float>(*sessions_[part].state().seat) - 0.5F;
}

std::size_t Guide::vacant_seat_near(float x) const noexcept {
  std::size_t nearest = 0;
  float distance = 2;
  for (std::size_t part = 1; part < sessions_.size(); ++part) {
    const float middle = column_middle(part) / static_cast<float>(seats());
    if (!sessions_[part].is_vacant() || std::abs(middle - x) >= distance) continue;
    distance = std::abs(middle - x);
    nearest = part;
  }
  return nearest;
}

/// Who stands before a glass reaches up further than to the side.
float Guide::millimetres(scene::ScreenPoint a, scene::ScreenPoint b) const noexcept {
  const float across = (a.x - b.x) * static_cast<float>(settings_.shape.width);
  const float down = (a.y - b.y) * static_cast<float>(settings_.shape.height);
  return std::hypot(across, reach_up * down) / interface::measures_of(settings_.shape).mm;
}

float Guide::column_millimetres() const noexcept {
  return static_cast<float>(settings_.shape.width) / static_cast<float>(seats()) /
         interface::measures_of(settings_.shape).mm;
}

scene::ScreenPoint Guide::middle_of_card(std::size_t part) const noexcept {
  if (part == 0) return {0.5F, 0.5F};
  const scene::Rect card = interface::card_of(settings_.shape, static_cast<std::uint32_t>(seats()),
                                              *sessions_[part].state().seat);
  return {card.x + card.width / 2, card.y + card.height / 2};
}

/// The card of a visitor who has gone on along the glass comes after them, if there is a seat.
void Guide::follow_territory(std::size_t part) noexcept {
  const std::size_t other = vacant_seat_near(territory_[part].x);
  if (other == 0 || sessions_[part].is_vacant()) return;
  const auto columns_off = [&](std::size_t of) {
    return std::abs(territory_[part].x * static_cast<float>(seats()) - column_middle(of));
  };
  if (columns_off(part) < strays_columns || columns_off(other) + 1 > columns_off(part)) return;
  interface::InterfaceState mine = sessions_[part].state(), theirs = sessions_[other].state();
  std::swap(mine.seat, theirs.seat);
  sessions_[part].show(mine);
  sessions_[other].show(theirs);
}

/// Which guides are taken, and whether there is room for more visitors.
void Guide::tell_each_other() noexcept {
  if (!is_shared()) return;
  const auto seated = std::span(sessions_).subspan(1);
  const auto there = std::ranges::count_if(seated, [](const Session& t) { return !t.is_vacant(); });
  std::uint8_t taken = 0;
  for (const Session& session : seated)
    if (session.guide()) taken = static_cast<std::uint8_t>(taken | 1U << *session.guide());
  // Guides for whom there was no room to wait are never free.
  for (std::size_t i = homes_.size(); i < scene::guide_look_count; ++i)
    taken = static_cast<std::uint8_t>(taken | 1U << i);
  const interface::Glass glass = there == 0 ? interface::Glass::Quiet : interface::Glass::Busy;
  for (Session& session : seated) {
    // Only to whom it matters: a card that changes is laid out anew.
    interface::InterfaceState state = session.state();
    state.glass = session.is_vacant() ? glass : interface::Glass::Busy;
    state.taken = session.guide() ? 0 : taken;
    session.show(state);
  }
  const bool is_full = there == static_cast<std::ptrdiff_t>(seated.size());
  interface::InterfaceState model = sessions_[0].state();
  model.glass = !is_full               ? glass
                : refusal_seconds_ > 0 ? interface::Glass::TurnedAway
                                       : interface::Glass::Full;
  sessions_[0].show(model);
}

// What the planner answers.

void Guide::resize(const interface::ScreenShape& shape) noexcept {
  if (shape == settings_.shape) return;
  settings_.shape = shape;
  for (Session& session : sessions_) session.request_view();
}

void Guide::take_answers() noexcept {
  while (std::unique_ptr<interface::View> view = planner_.take_view()) {
    const std::size_t part = view->part;
    if (part >= sessions_.size() || !sessions_[part].take_view(std::move(view))) continue;
    ++counters_.views;
    if (part == 0)
      stage_.enter(sessions_[0].state(), sessions_[0].view()->free,
                   interface::aspect_ratio(settings_.shape), leader());
  }
}

// What time brings.

void Guide::step(Seconds dt) noexcept {
  const float seconds = dt.count();
  take_answers();
  crowd_.step(seconds);
  strollers_.step(crowd_);
  const Agent& guide = crowd_[0];
  if (!is_shared() && guide.is_answered) {
    const plan::Plan& plan = guide.avatar.next ? *guide.avatar.next : *guide.avatar.plan;
    if (plan.order.id == guide.last_order && !plan.points.empty()) stage_.show_way(plan, list_);
  }
  counters_.routes = 0;
  for (Session& session : sessions_) {
    session.step(seconds, settings_.idle_reset.count());
    counters_.routes += session.routes();
  }
  refusal_seconds_ = std::max(0.0F, refusal_seconds_ - seconds);
  tell_each_other();
  stage_.advance(state(), leader(), seconds);
  counters_.collisions += crowd_.collisions();
}

std::span<const LedVisitor> Guide::led_visitors() noexcept {
  led_visitors_.clear();
  for (const Session& session : sessions_)
    if (session.guide() && session.leads_to_exhibit())
      led_visitors_.push_back({*session.guide(), session.state().exhibit, session.state().arrived});
  return led_visitors_;
}

const scene::DrawList& Guide::draw_list() noexcept {
  list_.avatars.clear();
  list_.palette.clear();
  list_.quads.clear();
  for (const Agent& one : crowd_.members())
    if (one.is_here) draw(museum_, one.avatar, list_);
  stage_.draw(state(), crowd_, led_visitors(), list_);
  const double floor_height = museum_.floors[leader().floor].plan.height;
  const bool names = is_shared() || state().screen == interface::Screen::Choosing;
  for (Session& session : sessions_) {
    session.overlay().follow(list_.camera, static_cast<float>(floor_height));
    session.overlay().draw(static_cast<float>(session.remaining()),
                           names && !stage_.is_flying() ? 1 : 0, list_);
  }
  return list_;
}

}  // namespace docent::guide
