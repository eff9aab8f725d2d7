#include "runtime/guide/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/guide/step_aside.h"
#include "runtime/interface/goal.h"
#include "runtime/interface/pictures.h"

namespace docent::guide {
namespace {

constexpr double at_home = 0.3;       ///< Metres from its place that still count as home.
constexpr float undecided_for = 20;   ///< Seconds that a seat is kept for who picks no guide.
constexpr float left_for = 0.4F;      ///< Seconds in which a touch is still of who has just left.
constexpr float forgotten_after = 5;  ///< Seconds in which starting over can be taken back.
constexpr float next_visitor_after = 20;  ///< Seconds after which a welcome is for somebody else.
/// On a card a flick is shorter than on the whole glass: this share of its column.
constexpr float flick_share = 0.3F;

input::GestureRecogniser recogniser_for(const interface::InterfaceState& state) noexcept {
  return !state.seat ? input::GestureRecogniser()
                     : input::GestureRecogniser(flick_share / static_cast<float>(state.seats));
}

}  // namespace

Session::Session(const SessionContext& context, std::uint32_t part,
                 const interface::InterfaceState& state, std::optional<std::uint32_t> guide)
    : context_(context),
      part_(part),
      state_(state),
      vacant_(state),
      guide_(guide),
      gestures_(recogniser_for(state)),
      overlay_(context.reduced_motion) {
  request_view();
}

bool Session::shows_its_state() const noexcept {
  return view() != nullptr && !awaiting_view_ && view()->state == state_;
}

bool Session::is_out() const noexcept {
  const Avatar& avatar = agent().avatar;
  const Vec2 off = avatar.body.position - context_.homes[*guide_].position;
  return avatar.floor != context_.museum.kiosk_floor || dot(off, off) > at_home * at_home ||
         !stands(avatar) || (agent().goal && !agent().has_arrived);
}

double Session::remaining() const noexcept {
  if (!guide_) return 0;
  if (left_to_walk_) return *left_to_walk_;
  const Avatar& avatar = agent().avatar;
  const plan::Plan& plan = *avatar.plan;
  if (const plan::Ride* ride = ride_of(avatar))
    return plan.metres_after + (1 - ride_share(context_.museum, avatar)) * ride->metres;
  return (plan.reach.empty() ? 0 : plan.reach.back() - avatar.along) + plan.beyond +
         plan.metres_after;
}

// What the visitor does.

bool Session::touch(const input::InputEvent& event, Overlay& surface) noexcept {
  if (event.kind == input::InputEvent::Kind::Cancel) {
    gestures_.take(event);
    surface.touch_up({event.contact, event.contact, 0});  // what it held is let go, not pressed
    return true;
  }
  // What lies on the glass and trembles is nobody.
  if (event.kind != input::InputEvent::Kind::Move) idle_seconds_ = 0;
  const std::optional<input::Gesture> gesture = gestures_.take(event);
  if (event.kind == input::InputEvent::Kind::Down) {
    overlay_.clear_focus();
    surface.touch_down({event.contact, event.contact, 0});
  }
  if (event.kind == input::InputEvent::Kind::Move)
    surface.touch_move({event.contact, event.contact, 0});
  return !gesture || press(*gesture, surface);
}

bool Session::press(const input::Gesture& gesture, Overlay& surface) noexcept {
  const bool has_dragged = surface.is_dragged_by(gesture.finger.at.id) ||
                           has_turned(gesture.finger) || closer_.has_moved(gesture.finger.at.id);
  const std::int32_t control = surface.touch_up(gesture.finger);
  const interface::View* shown = surface.view();
  if (shown == nullptr) return true;
  if (state_.asks_to_stay) {
    act({interface::Action::Kind::Stay});
    return true;
  }
  if (has_dragged) return true;
  if (state_.seat && is_vacant() &&
      (vacant_seconds_ < left_for || gesture.finger.seconds > vacant_seconds_))
    return true;
  if (surface.open_or_close(control)) return true;
  const bool on_own = &surface == &overlay_;
  if (gesture.kind != input::Gesture::Kind::Release && on_own &&
      state_.screen == interface::Screen::Choosing)
    swipe(gesture.kind == input::Gesture::Kind::SwipeLeft);
  else if (control >= 0)
    act(shown->controls[static_cast<std::size_t>(control)].action);
  else if (is_vacant())
    act({interface::Action::Kind::Begin});  // the whole glass invites
  else
    return false;
  return true;
}

void Session::swipe(bool left) noexcept {
  // What is further on comes from the side where lines end.
  const bool forwards = left != interface::runs_right_to_left(context_.museum, state_.language);
  const std::uint32_t pages = interface::page_count(
      context_.museum, state_, interface::exhibits_per_page(context_.shape, state_));
  if (forwards && state_.page + 1 < pages)
    act({interface::Action::Kind::TurnPage, state_.page + 1});
  if (!forwards && state_.page > 0) act({interface::Action::Kind::TurnPage, state_.page - 1});
}

void Session::press_key(input::Key key) noexcept {
  idle_seconds_ = 0;
  if (state_.asks_to_stay) return act({interface::Action::Kind::Stay});
  if (press_key_of_voice(key)) return;
  if (table_.exhibit() && (key == input::Key::Left || key == input::Key::Right))
    return table_.turn(key == input::Key::Left);
  switch (key) {
    case input::Key::Up:
    case input::Key::Left:
      return move_focus(-1);
    case input::Key::Down:
    case input::Key::Right:
      return move_focus(1);
    case input::Key::Enter:
      if (overlay_.focus() >= 0 && view() != nullptr)
        act(view()->controls[static_cast<std::size_t>(overlay_.focus())].action);
      else if (is_vacant())
        act({interface::Action::Kind::Begin});
      return;
    case input::Key::Back:
      if (state_.screen == interface::Screen::Choosing)
        act({state_.exhibit ? interface::Action::Kind::Return : interface::Action::Kind::Home});
      else if (state_.screen == interface::Screen::Picking)
        act({interface::Action::Kind::Home});
      else if (!is_vacant())
        act({interface::Action::Kind::ShowExhibits});
      return;
    default:
      return;
  }
}

/// A letter of a keyboard that hangs on the kiosk, while somebody searches.
void Session::type(char letter) noexcept {
  if (state_.screen != interface::Screen::Searching) return;
  const bool is_capital = letter >= 'A' && letter <= 'Z', is_digit = letter >= '0' && letter <= '9';
  if (!is_capital && !is_digit) return;
  act({interface::Action::Kind::Type,
       static_cast<std::uint32_t>(is_capital ? letter - 'A' + 'a' : letter)});
}

// What the visitor hears.

/// Help begins to read to whoever is not read to.
bool Session::press_key_of_voice(input::Key key) noexcept {
  if (state_.glass != interface::Glass::Whole) return false;
  if (sound_ && (key == input::Key::VolumeUp || key == input::Key::VolumeDown)) {
    voice_.turn_volume(key);
    return true;
  }
  if (voice_.press_key(key)) return true;
  if (key != input::Key::Help) return false;
  if (state_.speaks)
    voice_.help();
  else
    act({interface::Action::Kind::ReadAloud, 1});
  return true;
}

void Session::move_focus(int step) noexcept {
  overlay_.move_focus(step);
  voice_.moved_to(overlay_.focus());
}

void Session::headphones(bool are_in) noexcept {
  has_headphones_ = are_in;
  if (state_.glass != interface::Glass::Whole || state_.speaks == are_in) return;
  idle_seconds_ = 0;
  act({interface::Action::Kind::ReadAloud, are_in ? 1U : 0U});
}

void Session::speak(float seconds) noexcept {
  std::optional<float> left;
  if (state_.screen == interface::Screen::Walking && leads_to_goal() && route_summary_ &&
      route_summary_->status == path::RouteStatus::Ok)
    left = static_cast<float>(remaining());
  if (!voice_.step(seconds, view(), left)) return;
  const std::int32_t before = overlay_.focus();
  overlay_.move_focus(1);
  voice_.read(before, overlay_.focus());
}

void Session::act(interface::Action action) noexcept {
  voice_.pressed();
  if (action.kind == interface::Action::Kind::Resume) return resume();
  if (action.kind == interface::Action::Kind::Scroll)
    return overlay_.turn(action.argument == 0 ? -1 : 1);
  const bool was_vacant = is_vacant();
  if (!state_.seat) left_.reset();
  if (!state_.seat && !was_vacant && action.kind == interface::Action::Kind::Home) {
    left_ = state_;
    left_seconds_ = 0;
    overlay_.clear_focus();
  }
  interface::InterfaceState next = interface::after(state_, action);
  if (action.kind == interface::Action::Kind::ShowPicture)  // who wants no motion begins it
    next.plays = !context_.reduced_motion && interface::shown_video(context_.museum, next);
  show(next);
  if (was_vacant && !is_vacant()) begin_visit();
  switch (action.kind) {
    case interface::Action::Kind::PlayVideo:
    case interface::Action::Kind::ShowPicture:
      has_asked_for_video_ = action.kind == interface::Action::Kind::PlayVideo;
      break;
    case interface::Action::Kind::ReadAloud:
      voice_.reset();
      break;
    case interface::Action::Kind::Begin:
      if (guide_) context_.crowd.greet(*guide_);
      break;
    case interface::Action::Kind::Pick:
      if (state_.look != action.argument) break;
      guide_ = action.argument;
      context_.crowd.greet(*guide_);
      set_out();  // where they have touched an exhibit first
      break;
    case interface::Action::Kind::Choose:
    case interface::Action::Kind::FollowTour:
    case interface::Action::Kind::Seek:
    case interface::Action::Kind::GoToPlace:
    case interface::Action::Kind::TakeRoute:
    case interface::Action::Kind::AvoidSteps:
    case interface::Action::Kind::AvoidEscalators:
      set_out();  // to another goal, by another way, or at last by any
      break;
    case interface::Action::Kind::Stop:
      order({.kind = Errand::Kind::Stop});
      break;
    case interface::Action::Kind::Home:
      voice_.reset();
      go_home();
      break;
    default:
      break;
  }
}

/// Starting over is taken back: the visitor is where they were, and the guide turns round.
void Session::resume() noexcept {
  if (!left_) return;
  interface::InterfaceState before = *left_;
  left_.reset();
  before.arrived = false;
  before.plays = false;  // whoever comes back begins it
  before.sound.reset();
  if (before.screen == interface::Screen::Arrived) before.screen = interface::Screen::Walking;
  show(before);
  set_out();
}

/// What the last visitor chose is kept for a moment, and then for nobody.
void Session::keep_to_resume(float seconds) noexcept {
  if (!left_) return;
  left_seconds_ += seconds;
  if (left_seconds_ < forgotten_after) return;
  left_.reset();
  interface::InterfaceState state = state_;
  state.can_resume = false;
  show(state);
}

/// Sends the guide to the chosen goal by the chosen kind of way, unless it is on that way.
void Session::set_out() noexcept {
  Errand errand{.kind = Errand::Kind::ToGoal,
                .exhibit = state_.exhibit,
                .seeks = state_.seeks,
                .route = state_.kind,
                .permissions = state_.ways};
  if (!errand.seeks) errand.place = state_.place;
  if (!guide_ || state_.arrived || !interface::has_goal(state_) || errand_ == errand) return;
  if (stands(agent().avatar)) context_.crowd.greet(*guide_);
  order(errand);
}

void Session::lead(const Errand& errand) noexcept {
  if (errand.seeks)
    return context_.crowd.seek(*guide_, *errand.seeks, errand.route, errand.permissions);
  const auto goal = interface::goal_of(context_.museum, state_);
  if (goal)
    context_.crowd.send(*guide_, goal->floor, goal->standing, errand.route, errand.permissions,
                        errand.exhibit);
}

void Session::order(const Errand& errand) noexcept {
  if (!guide_) return;
  if (errand != waiting_errand_) left_to_walk_.reset();
  errand_ = errand;
  ends_aside_ = false;
  route_summary_.reset();
  switch (errand.kind) {
    case Errand::Kind::ToGoal:
      lead(errand);
      break;
    case Errand::Kind::Home:
      context_.crowd.send(*guide_, context_.museum.kiosk_floor, context_.homes[*guide_],
                          errand.route);
      break;
    default:
      context_.crowd.stop(*guide_);
      break;
  }
  request_view();
}

bool Session::can_meet() const noexcept {
  return guide_ && agent().is_here && !is_between_floors(agent()) && !agent().is_away &&
         ride_of(agent().avatar) == nullptr &&
         (errand_.kind == Errand::Kind::None || errand_.kind == Errand::Kind::ToGoal);
}

void Session::meet(const Placement& place) noexcept {
  waiting_errand_ = errand_;
  left_to_walk_ = remaining();
  // Who is on its way back to where it stood before still goes there.
  if (!agent().goal || agent().has_arrived || agent().goal->position != stood_.position)
    stood_ = agent().avatar.body;
  errand_ = {.kind = Errand::Kind::Meet};
  context_.crowd.send(*guide_, agent().avatar.floor, place, RouteKind::Shortest, state_.ways);
}

void Session::part() noexcept {
  if (!is_meeting() || !guide_) return;
  if (waiting_errand_.kind == Errand::Kind::ToGoal && !state_.arrived)
    return order(waiting_errand_);
  // It goes back to where it waited, or showed something.
  errand_ = waiting_errand_;
  ends_aside_ = true;
  context_.crowd.send(*guide_, agent().avatar.floor, stood_, RouteKind::Shortest, state_.ways);
}

/// At a seat the guide is free from now on, for whoever comes next.
void Session::go_home() noexcept {
  if (guide_ && is_out() && errand_.kind != Errand::Kind::Home) order({.kind = Errand::Kind::Home});
  if (!state_.seat) return;
  guide_.reset();
  left_to_walk_.reset();
  errand_ = {};
  route_summary_.reset();
  vacant_seconds_ = 0;
}

/// On the glass of one visitor every visit begins where they stand, wherever the last one ended.
void Session::begin_visit() noexcept {
  if (state_.seat || !guide_ || !is_out()) return;
  context_.crowd.appear(*guide_, context_.museum.kiosk_floor, context_.homes[*guide_]);
  errand_ = {};
  ends_aside_ = false;
  route_summary_.reset();
}

void Session::show(const interface::InterfaceState& state) noexcept {
  if (state_ == state) return;
  state_ = state;
  request_view();
}

// What the visitor watches.

std::optional<ShownVideo> Session::video() const noexcept {
  if (!video_ || view() == nullptr || view()->video == scene::TextureId::None ||
      interface::shown_video(context_.museum, view()->state) != video_)
    return std::nullopt;
  return ShownVideo{.image = *video_,
                    .texture = view()->video,
                    .seconds = video_seconds_,
                    .plays = state_.plays,
                    .is_asked_for = has_asked_for_video_};
}

void Session::video_ended() noexcept {
  video_seconds_ = 0;
  stop_video();
}

void Session::stop_video() noexcept {
  interface::InterfaceState state = state_;
  state.plays = false;
  show(state);
}

void Session::play_video(float seconds) noexcept {
  constexpr float longest = 61;  // no video is longer: video::Limits
  const auto before = std::exchange(video_, interface::shown_video(context_.museum, state_));
  if (video_ != before) video_seconds_ = 0;
  if (video_ && state_.plays && video()) video_seconds_ += seconds;
  if (video_seconds_ > longest) video_ended();
  const bool is_begun = video() && (state_.plays || video_seconds_ > 0);
  overlay_.watch(is_begun ? std::optional(video_seconds_) : std::nullopt);
}

// What the planner answers.

void Session::request_view() noexcept {
  awaiting_view_ = true;
  context_.planner.ask(
      interface::ViewRequest{++last_request_, state_, context_.shape, route_summary_, part_});
}

bool Session::take_view(std::unique_ptr<interface::View> view) noexcept {
  if (view->request != last_request_) return false;  // the visitor has gone on
  awaiting_view_ = false;
  state_.own_tour = view->state.own_tour;  // the worker has put it in order
  state_.found = view->state.found;        // and looked up what was typed
  overlay_.enter(std::move(view));
  if (voice_.enter(*overlay_.view(), overlay_.focus())) overlay_.clear_focus();
  return true;
}

void Session::heed_closures() noexcept {
  interface::order_anew(state_.own_tour);
  set_out();
  request_view();
}

/// The crowd has been told about the guide's way.
void Session::take_way() noexcept {
  if (!guide_ || !agent().is_answered || !leads_to_goal()) return;
  const auto& summary = agent().route_summary;
  if (ends_aside_ && summary && summary->status == path::RouteStatus::Ok) return;
  if (!route_summary_) ++routes_;
  if (errand_.seeks && agent().place != none) state_.place = agent().place;
  route_summary_ = agent().route_summary;
  if (route_summary_ && route_summary_->status != path::RouteStatus::Ok) {
    errand_ = {};
    state_.skips = false;
    context_.crowd.stop(*guide_);  // it goes on no farther to where it was going before
  }
  request_view();
}

// What time brings.

void Session::step(float seconds, float absent_after, float liveliness) noexcept {
  turn_object(seconds, liveliness);
  take_way();
  go_on_after_meeting();
  step_aside();
  notice_floor();
  notice_arrival();
  notice_absence(seconds, absent_after);
  keep_to_resume(seconds);
  vacant_seconds_ += seconds;
  gestures_.advance(seconds);
  overlay_.advance(seconds);
  play_video(seconds);
  speak(seconds);
  play_sound(seconds);
}

/// Until the plan of the way to its goal is walked, what is left of a plan is the meeting's.
void Session::go_on_after_meeting() noexcept {
  if (!guide_ || is_meeting() || !agent().is_on_its_way || agent().avatar.next) return;
  left_to_walk_.reset();
}

/// What is touched from one side only is shown from there.
std::optional<Side> Session::side_to_touch_from() const noexcept {
  const std::vector<Touch>& touches = context_.museum.exhibits[*state_.exhibit].touches;
  if (context_.reduced_motion || touches.size() != 1) return {};
  return touches.front().beside;
}

/// Near the end of its way the guide turns to a place beside it, so that it hides nothing.
void Session::step_aside() noexcept {
  if (!guide_ || !leads_to_goal() || ends_aside_ || !state_.exhibit || state_.arrived) return;
  const Avatar& avatar = agent().avatar;
  const auto goal = interface::goal_of(context_.museum, state_);
  if (!goal || avatar.floor != goal->floor || remaining() > turns_aside ||
      !context_.crowd.is_about_to_arrive(*guide_))
    return;
  std::optional<double> yaw;
  if (state_.seat) yaw = context_.museum.kiosk.heading;
  const auto place = place_aside(*context_.planner.maps()[goal->floor], *goal,
                                 context_.exhibit_shapes[*state_.exhibit], avatar.body, yaw,
                                 context_.museum.body_radius, side_to_touch_from());
  ends_aside_ = true;
  if (place) context_.crowd.end_at(*guide_, *place);
}

void Session::notice_arrival() noexcept {
  if (!guide_ || errand_.kind == Errand::Kind::None || is_meeting() || agent().awaits_answer ||
      !stands(agent().avatar) || !agent().has_arrived)
    return;
  if (errand_.kind != Errand::Kind::ToGoal) {
    errand_ = {};
    return;
  }
  interface::InterfaceState now = state_;
  if (now.arrived) return;
  now.arrived = true;
  now.skips = false;
  if (const auto goal = interface::goal_of(context_.museum, state_))
    now.floor = goal->floor;  // that is where they are looking
  if (now.screen == interface::Screen::Walking) now.screen = interface::Screen::Arrived;
  show(now);
}

/// The small plan is of the floor that the guide is on.
void Session::notice_floor() noexcept {
  if (!guide_ || state_.screen != interface::Screen::Walking || !leads_to_goal()) return;
  const std::uint32_t floor = agent().avatar.shown_floor;
  if (state_.guide_floor.value_or(context_.museum.kiosk_floor) == floor) return;
  interface::InterfaceState now = state_;
  now.guide_floor = floor;
  show(now);
}

/// Nobody has touched the glass for a while: whoever comes next is greeted in the first language.
void Session::notice_absence(float seconds, float absent_after) noexcept {
  const bool follows =
      state_.screen == interface::Screen::Walking && guide_ && !stands(agent().avatar);
  if (voice_.is_busy() || sound_ || (state_.plays && video()))
    return;  // who listens or watches does nothing
  idle_seconds_ = follows ? 0 : idle_seconds_ + seconds;
  if (state_.screen == interface::Screen::Picking)
    absent_after = std::min(absent_after, undecided_for);
  if (is_vacant()) absent_after = std::min(absent_after, next_visitor_after);
  ask_to_stay(absent_after);
  if (idle_seconds_ < absent_after) return;
  idle_seconds_ = 0;
  overlay_.clear_focus();
  interface::InterfaceState vacant = vacant_;
  vacant.glass = state_.glass;
  vacant.seat = state_.seat;
  vacant.taken = state_.taken;
  vacant.speaks = has_headphones_;
  vacant.can_sound = state_.can_sound;
  if (state_ == vacant) return;
  act({interface::Action::Kind::Home});
  left_.reset();
  show(vacant);
}

/// Before the glass is made ready for somebody else, whoever may be there is asked.
void Session::ask_to_stay(float absent_after) noexcept {
  if (state_.seat || state_.glass != interface::Glass::Whole || is_vacant()) return;
  const float left = absent_after - idle_seconds_;
  overlay_.count_down(left);
  interface::InterfaceState state = state_;
  state.asks_to_stay = left <= std::min(Overlay::countdown_seconds, absent_after / 3);
  show(state);
}

}  // namespace docent::guide
