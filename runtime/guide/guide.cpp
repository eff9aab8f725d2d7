#include "runtime/guide/guide.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace docent {
namespace {

constexpr std::size_t most_ribbon_points = 4096, most_quads = 1024, most_markers = 512;
constexpr std::size_t points_of_a_trail = 1024;
constexpr std::size_t most_pieces = 4096;
constexpr double guide_rank = 100;  ///< Visitors on their own make room for a guide.
constexpr double at_home = 0.3;     ///< Metres from the kiosk that still count as home.
constexpr double touching = 0.01;   ///< Metres of the body that may be in a wall unremarked.

}  // namespace

Guide::Guide(const Museum& museum, Planner& planner, const GuideSettings& settings)
    : museum_(museum),
      planner_(planner),
      settings_(settings),
      visitors_(1),
      company_(museum, planner),
      strollers_(museum),
      stage_(museum),
      memory_(most_pieces, TextureId::None) {
  company_.add(museum.kiosk_floor, museum.kiosk, guide_rank, 1);
  strollers_.enter(company_);
  bodies_.reserve(company_.size());
  if (company_.size() > 1 && museum.kiosk_floor < planner.maps().size())
    meetings_.emplace_back(*planner.maps()[museum.kiosk_floor], company_.size());
  list_.avatars.reserve(company_.size());
  list_.palette.reserve(company_.size() * leader().world.size());
  const auto guides =
      static_cast<std::size_t>(std::ranges::count_if(company_.members(), leaves_a_trail));
  list_.ribbons.reserve(guides);
  list_.ribbon_point.reserve(most_ribbon_points + (guides - 1) * points_of_a_trail);
  list_.markers.reserve(std::max(most_markers, museum.exhibits.size() + 8));
  list_.quads.reserve(std::max(most_quads, museum.exhibits.size() * 4 + 512));
  request_view();
}

bool Guide::shows_its_state() const noexcept {
  return view() != nullptr && !awaiting_view_ && view()->state == state();
}

bool Guide::is_settled() const noexcept {
  return shows_its_state() && !overlay_.is_fading() && !stage_.is_flying();
}

bool Guide::is_out() const noexcept {
  const Vec2 off = leader().body.position - museum_.kiosk.position;
  return dot(off, off) > at_home * at_home || !stands(leader());
}

AvatarState Guide::state_of(std::uint32_t who) const noexcept {
  const Companion& one = company_[who];
  switch (one.avatar.gait) {
    case Gait::Turn:
      return AvatarState::Turn;
    case Gait::Walk:
      return AvatarState::Walk;
    case Gait::Idle:
      break;
  }
  if (one.goal && !one.has_arrived) return AvatarState::Wait;
  const bool looks = who == 0 ? state().arrived : one.goal.has_value();
  return looks ? AvatarState::Look : AvatarState::Idle;
}

// What visitors do.

void Guide::touch(const InputEvent& event) noexcept {
  visitors_.front().idle_seconds = 0;
  if (event.kind == InputEvent::Kind::KeyDown) return press_key(event.key);
  const std::optional<Gesture> gesture = gestures_.take(event);
  if (event.kind == InputEvent::Kind::Down) {
    ++counters_.touches;
    overlay_.clear_focus();
    overlay_.touch_down({event.contact, event.contact, 0});
  }
  if (gesture) press(*gesture);
}

void Guide::press(const Gesture& gesture) noexcept {
  const std::int32_t control = overlay_.touch_up(gesture.finger);
  const View* shown = view();
  if (shown == nullptr) return;
  const bool swiped = gesture.kind != Gesture::Kind::Release;
  if (swiped && state().screen == Screen::Choosing) {
    // What is further on comes from the side where lines end.
    const bool forwards =
        (gesture.kind == Gesture::Kind::SwipeLeft) != runs_right_to_left(museum_, state().language);
    const std::uint32_t pages = page_count(museum_, exhibits_per_page(settings_.shape));
    if (forwards && state().page + 1 < pages) act({Action::Kind::TurnPage, state().page + 1});
    if (!forwards && state().page > 0) act({Action::Kind::TurnPage, state().page - 1});
    return;
  }
  if (control >= 0)
    act(shown->controls[static_cast<std::size_t>(control)].action);
  else if (state().screen == Screen::Welcome)
    act({Action::Kind::Begin});  // the whole glass invites
}

void Guide::press_key(Key key) noexcept {
  switch (key) {
    case Key::Up:
    case Key::Left:
      return overlay_.move_focus(-1);
    case Key::Down:
    case Key::Right:
      return overlay_.move_focus(1);
    case Key::Enter:
      if (overlay_.focus() >= 0 && view() != nullptr)
        act(view()->controls[static_cast<std::size_t>(overlay_.focus())].action);
      else if (state().screen == Screen::Welcome)
        act({Action::Kind::Begin});
      return;
    case Key::Back:
      if (state().screen == Screen::Choosing)
        act({state().exhibit >= 0 ? Action::Kind::Return : Action::Kind::Home});
      else if (state().screen != Screen::Welcome)
        act({Action::Kind::ShowExhibits});
      return;
    default:
      return;
  }
}

void Guide::act(Action action) noexcept {
  const InterfaceState before = state();
  show(after(before, action));
  switch (action.kind) {
    case Action::Kind::Choose:
      set_out();
      break;
    case Action::Kind::TakeRoute:
      if (errand_.kind == Errand::Kind::ToExhibit && !before.arrived) set_out();
      break;
    case Action::Kind::Stop:
      order({.kind = Errand::Kind::Stop});
      break;
    case Action::Kind::Home:
      if (is_out() && errand_.kind != Errand::Kind::Home) order({.kind = Errand::Kind::Home});
      break;
    default:
      break;
  }
}

/// Sends the guide to the chosen exhibit by the chosen kind of way, unless it is on that way.
void Guide::set_out() noexcept {
  const Errand errand{Errand::Kind::ToExhibit, state().exhibit, state().kind};
  if (state().arrived || errand.exhibit < 0) return;
  if (errand_.kind == errand.kind && errand_.exhibit == errand.exhibit &&
      errand_.route == errand.route)
    return;
  order(errand);
}

void Guide::order(const Errand& errand) noexcept {
  errand_ = errand;
  trip_.reset();
  switch (errand.kind) {
    case Errand::Kind::ToExhibit:
      company_.send(0, museum_.exhibits[static_cast<std::size_t>(errand.exhibit)].view,
                    errand.route);
      break;
    case Errand::Kind::Home:
      company_.send(0, museum_.kiosk, errand.route);
      break;
    default:
      company_.stop(0);
      break;
  }
  request_view();
}

// What the planner answers.

void Guide::show(const InterfaceState& state) noexcept {
  if (visitors_.front().state == state) return;
  visitors_.front().state = state;
  request_view();
}

void Guide::request_view() noexcept {
  awaiting_view_ = true;
  planner_.ask(ViewRequest{++last_request_, state(), settings_.shape, trip_});
}

void Guide::resize(const ScreenShape& shape) noexcept {
  if (shape == settings_.shape) return;
  settings_.shape = shape;
  request_view();
}

void Guide::bind(TextureId piece, TextureId memory) noexcept {
  const auto i = static_cast<std::size_t>(piece);
  if (i < memory_.size()) memory_[i] = memory;
}

TextureId Guide::memory_of(TextureId piece) const noexcept {
  const auto i = static_cast<std::size_t>(piece);
  return i < memory_.size() ? memory_[i] : TextureId::None;
}

void Guide::take_answers() noexcept {
  while (std::unique_ptr<View> view = planner_.take_view()) {
    if (view->request != last_request_) continue;  // the visitor has gone on
    awaiting_view_ = false;
    ++counters_.views;
    stage_.enter(view->state, view->free, aspect_ratio(settings_.shape), leader());
    overlay_.enter(std::move(view));
  }
}

/// The company has been told about the guide's way.
void Guide::take_way() noexcept {
  const Companion& guide = company_[0];
  if (!guide.is_answered) return;
  const Plan& plan = guide.avatar.next ? *guide.avatar.next : *guide.avatar.plan;
  if (plan.order.id == guide.last_order && !plan.points.empty()) stage_.show_way(plan, list_);
  if (errand_.kind != Errand::Kind::ToExhibit) return;
  if (!trip_) ++counters_.routes;
  trip_ = guide.trip;
  if (trip_ && trip_->status != RouteStatus::Ok) errand_ = {};
  request_view();
}

// What time brings.

void Guide::step(Seconds dt) noexcept {
  const float seconds = dt.count();
  take_answers();
  company_.step(seconds);
  strollers_.step(company_);
  take_way();
  notice_arrival();
  notice_absence(seconds);
  gestures_.advance(seconds);
  overlay_.advance(seconds);
  stage_.advance(state(), leader(), seconds);
  count_collisions();
}

void Guide::notice_arrival() noexcept {
  const Companion& guide = company_[0];
  if (errand_.kind == Errand::Kind::None || guide.awaits_answer || !stands(guide.avatar) ||
      !guide.has_arrived)
    return;
  if (errand_.kind != Errand::Kind::ToExhibit) {
    errand_ = {};
    return;
  }
  InterfaceState now = state();
  if (now.arrived) return;
  now.arrived = true;
  if (now.screen == Screen::Walking) now.screen = Screen::Arrived;
  show(now);
}

/// Nobody has touched the glass for a while: whoever comes next is greeted in the first language.
void Guide::notice_absence(float seconds) noexcept {
  Visitor& visitor = visitors_.front();
  const bool follows = visitor.state.screen == Screen::Walking && !stands(leader());
  visitor.idle_seconds = follows ? 0 : visitor.idle_seconds + seconds;
  if (visitor.idle_seconds < settings_.idle_reset.count()) return;
  visitor.idle_seconds = 0;
  overlay_.clear_focus();
  if (visitor.state == InterfaceState{}) return;
  act({Action::Kind::Home});
  show({});
}

void Guide::count_collisions() noexcept {
  bodies_.clear();
  const double radius = museum_.body_radius - touching;
  for (const Companion& one : company_.members()) {
    if (!one.is_here) continue;
    const Vec2 place = one.avatar.body.position;
    bodies_.push_back({.position = place, .radius = radius});
    if (one.avatar.floor < planner_.maps().size() &&
        clearance_at(*planner_.maps()[one.avatar.floor], place) < radius)
      ++counters_.collisions;
  }
  if (bodies_.size() < 2) return;
  for (Meetings& meetings : meetings_) {
    meetings.update(bodies_);
    counters_.collisions += meetings.find(0).size();
  }
}

const DrawList& Guide::draw_list() noexcept {
  list_.avatars.clear();
  list_.palette.clear();
  list_.quads.clear();
  for (const Companion& one : company_.members())
    if (one.is_here) draw(museum_, one.avatar, list_);
  stage_.draw(state(), company_, errand_.kind == Errand::Kind::ToExhibit, list_);
  const double floor_height = museum_.floors[leader().floor].plan.height;
  overlay_.follow(list_.camera, static_cast<float>(floor_height));
  const double whole = leader().plan->reach.empty() ? 0 : leader().plan->reach.back();
  const bool names = state().screen == Screen::Choosing;
  overlay_.draw(static_cast<float>(whole - leader().along), names && !stage_.is_flying() ? 1 : 0,
                list_);
  for (Quad& quad : list_.quads) quad.texture = memory_of(quad.texture);
  return list_;
}

}  // namespace docent
