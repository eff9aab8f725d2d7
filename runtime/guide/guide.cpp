#include "runtime/guide/guide.h"

#include <algorithm>
#include <utility>

#include "runtime/guide/stature.h"
#include "runtime/guide/waiting_places.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/look.h"
#include "runtime/scene/side.h"
#include "runtime/scene/theme.h"

namespace docent::guide {
namespace {

constexpr std::size_t most_ribbon_points = 4096, most_quads = 1024, most_markers = 512;
constexpr std::size_t points_of_a_trail = 1024;
constexpr std::size_t quads_of_a_card = 256;
constexpr std::size_t most_contacts = 80;
constexpr double guide_rank = 100;  ///< Visitors on their own make room for a guide.
constexpr scene::Rect above_welcome{0, 0, 1, 0.82F};  ///< On an upright screen, while alone.
constexpr int skipping_pace = 10;                     ///< Times as fast as in reality.
constexpr float refusal_shown_for = 8;                ///< Seconds.

/// Nobody shares a glass that has one seat; where it is not said, who shares one stands below it.
GuideSettings settled(GuideSettings settings) noexcept {
  if (settings.shape.sides.count() == 0) settings.shape.sides.add(scene::Side::Bottom);
  if (interface::seats_on(settings.shape, settings.visitors) <= 1) settings.shape.sides = {};
  return settings;
}

std::size_t guides_on(const GuideSettings& settings) noexcept {
  return interface::seats_on(settings.shape, settings.visitors) > 1 ? scene::guide_look_count : 1;
}

}  // namespace

PlannerSize planner_size(const Museum& museum, const GuideSettings& settings) noexcept {
  const GuideSettings on = settled(settings);
  const std::size_t seats = interface::seats_on(on.shape, on.visitors);
  return {guides_on(on) + Strollers::most(museum), seats > 1 ? 1 + seats : 1 + Captions::part};
}

Guide::Guide(const Museum& museum, plan::Planner& planner, const GuideSettings& settings)
    : museum_(museum),
      planner_(planner),
      settings_(settled(settings)),
      crowd_(museum, planner),
      strollers_(museum),
      doors_(museum),
      handshakes_(museum),
      exhibit_shapes_(exhibit_shapes(museum)),
      attention_(museum, exhibit_shapes_),
      attract_(museum),
      chapters_(museum),
      captions_(settings.reduced_motion),
      stage_(museum, exhibit_shapes_, settings.reduced_motion) {
  enter_guides();
  if (settings.reduced_motion)
    crowd_.hold_still();
  else
    strollers_.enter(crowd_);
  take_seats();
  light_ = scene::light_of(museum.livery, settings_.shape.is_night);
  if (!settings.reduced_motion) touches_.emplace(museum);
  list_.walls = stage_.walls();
  list_.leaves.reserve(std::min(doors_.leaves().size(), scene::most_leaves));
  list_.avatars.reserve(crowd_.size());
  list_.palette.reserve(crowd_.size() * leader().palette.size());
  list_.joint.reserve(list_.palette.capacity());
  const auto guides =
      static_cast<std::size_t>(std::ranges::count_if(crowd_.members(), leaves_a_trail));
  list_.objects.reserve(museum.exhibits.size());
  list_.ribbons.reserve(guides);
  list_.ribbon_point.reserve(most_ribbon_points + (guides - 1) * points_of_a_trail);
  list_.markers.reserve(std::max(most_markers, museum.exhibits.size() + 8) +
                        2 * interface::most_seats);
  list_.quads.reserve(
      std::max(most_quads, (museum.exhibits.size() + museum.places.size()) * 8 + 1024) +
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
  const bool shared = seats > 1;
  if (!shared) settings_.shape.sides = {};  // there was no place for a second guide to wait
  const SessionContext context{museum_,
                               planner_,
                               crowd_,
                               settings_.shape,
                               homes_,
                               exhibit_shapes_,
                               settings_.reduced_motion};
  sessions_.reserve(shared ? 1 + seats : 1);
  interface::InterfaceState state;
  state.kind = state.usual_kind = usual_kind(museum_.ways);
  state.can_lower = !shared && interface::can_be_lowered(settings_.shape);
  state.can_sound = !shared && settings_.can_sound;
  state.glass = shared ? interface::Glass::Quiet : interface::Glass::Whole;
  state.seats = shared ? static_cast<std::uint8_t>(seats) : 0;
  sessions_.emplace_back(context, 0, state,
                         shared ? std::nullopt : std::optional<std::uint32_t>(0));
  for (std::size_t seat = 0; shared && seat < seats; ++seat) {
    state.seat = static_cast<std::uint32_t>(seat + 1);
    sessions_.emplace_back(context, static_cast<std::uint32_t>(seat + 1), state, std::nullopt);
  }
  if (shared) seating_.emplace(sessions_, settings_.shape);
  held_.reserve(most_contacts);
  led_visitors_.reserve(sessions_.size() + 1);  // and who is led while nobody is there
  speaker_ = shared ? 1 : 0;
}

std::size_t Guide::part_of(std::optional<std::uint32_t> seat) const noexcept {
  const std::optional<std::size_t> part =
      seat && seating_ ? seating_->part_of(*seat) : std::nullopt;
  return part.value_or(speaker_);
}

bool Guide::shows_its_state(std::size_t part) const noexcept {
  return sessions_[part].shows_its_state();
}

std::vector<interface::OnGlass> Guide::on_glass() const {
  std::vector<interface::OnGlass> all;
  for (const Session& session : sessions_) {
    if (session.view() == nullptr) continue;
    for (interface::OnGlass& item : interface::on_glass(
             museum_, *session.view(), settings_.shape, static_cast<float>(session.remaining()),
             session.overlay().focus(), session.overlay().scrolled()))
      all.push_back(std::move(item));
  }
  if (const interface::View* caption = captions_.view(); caption != nullptr)
    for (interface::OnGlass& item :
         interface::on_glass(museum_, *caption, settings_.shape, captions_.left(), -1))
      all.push_back(std::move(item));
  return all;
}

bool Guide::is_settled(std::size_t part) const noexcept {
  return shows_its_state(part) && !sessions_[part].overlay().is_fading() && !stage_.is_flying();
}

bool Guide::is_vacant() const noexcept {
  return std::ranges::all_of(sessions_, &Session::is_vacant);
}

AvatarState Guide::state_of(std::uint32_t who) const noexcept {
  const Agent& one = crowd_[who];
  const motion::Gesture gesture = one.avatar.manner.gesture;
  const bool gestures = gesture == motion::Gesture::Wave || gesture == motion::Gesture::Point;
  if (holds(one.avatar.manner)) return AvatarState::Gesture;
  switch (one.avatar.gait) {
    case motion::Gait::Turn:
      return AvatarState::Turn;
    case motion::Gait::Walk:
      return AvatarState::Walk;
    case motion::Gait::Idle:
      break;
  }
  if (one.goal && !one.has_arrived) return AvatarState::Wait;
  if (gestures) return AvatarState::Gesture;
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
      wake();
      if (seating_) seating_->press_key(speaker_);
      sessions_[speaker_].press_key(event.key);
      if (event.key == input::Key::Character) sessions_[speaker_].type(event.character);
      return tell_each_other();
    case input::InputEvent::Kind::Down:
      put_down(event);
      break;
    case input::InputEvent::Kind::Move:
    case input::InputEvent::Kind::Up:
    case input::InputEvent::Kind::Cancel:
      break;
  }
  const auto held = std::ranges::find(held_, event.contact.id, &Held::contact);
  if (held == held_.end()) return;
  if (event.kind == input::InputEvent::Kind::Move) held->at = {event.contact.x, event.contact.y};
  const Held finger = *held;
  input::InputEvent seen = event;
  const scene::ScreenPoint at =
      scene::as_seen_from(finger.side, scene::ScreenPoint{event.contact.x, event.contact.y});
  seen.contact.x = at.x;
  seen.contact.y = at.y;
  if (event.kind != input::InputEvent::Kind::Down && event.kind != input::InputEvent::Kind::Move)
    held_.erase(held);
  const bool meant = sessions_[finger.visitor].touch(seen, sessions_[finger.surface].overlay());
  if (!meant && finger.surface == 0 && is_shared())
    if (const auto whom = guide_at(finger.at)) {
      wish(finger.visitor, *whom, finger.at);
      return tell_each_other();
    }
  // Perhaps somebody who found no seat.
  if (!meant && finger.surface == 0 && state().glass == interface::Glass::Full)
    refusal_seconds_ = refusal_shown_for;
  tell_each_other();
}

void Guide::headphones(bool are_in) noexcept {
  if (are_in) wake();
  if (!is_shared()) sessions_[0].headphones(are_in);
}

/// Whoever comes finds the first screen, and the guide at its place.
bool Guide::wake() noexcept {
  if (!attract_.wake()) return false;
  strollers_.leave(crowd_);
  crowd_.appear(0, museum_.kiosk_floor, homes_[0]);
  stage_.sway(0, 1);
  if (view() == nullptr) return true;
  stage_.enter(state(), {view()->free, view()->boards}, interface::aspect_ratio(settings_.shape),
               leader());
  stage_.cut(state(), leader());
  // What is written on the model is where it was.
  const scene::CameraView camera =
      scene::view_of(stage_.rig(), interface::aspect_ratio(settings_.shape));
  for (Session& session : sessions_) session.overlay().follow(camera, height_of_floor());
  return true;
}

/// Whatever has rested on the glass until nobody is taken to be there presses nothing later.
void Guide::let_go() noexcept {
  for (const Held& held : held_)
    sessions_[held.visitor].touch(
        {.kind = input::InputEvent::Kind::Cancel, .contact = {.id = held.contact}},
        sessions_[held.surface].overlay());
  held_.clear();
}

/// Whose guide a finger on the model of a shared glass means: the one it is on, or nearly.
std::optional<std::uint32_t> Guide::guide_at(scene::ScreenPoint at) const noexcept {
  const DrawnSize size = drawn_size();
  std::optional<std::uint32_t> found;
  float nearest = nearly_on_figure;
  for (std::uint32_t who = 0; who < homes_.size(); ++who) {
    const Agent& one = crowd_[who];
    if (!is_to_be_seen(one) || one.avatar.shown_floor != stage_.floor() ||
        std::ranges::none_of(sessions_, [&](const Session& s) { return s.guide() == who; }))
      continue;
    const float off = millimetres_to_figure(
        size.camera, settings_.shape, to_world(one.avatar.body.position, one.avatar.height), at);
    if (off >= nearest) continue;
    nearest = off;
    found = who;
  }
  return found;
}

/// A touch of a guide on the model is that of somebody else than its own visitor: hands reach over
/// each other there, and one's own guide is told what to do on its card.
void Guide::wish(std::size_t part, std::uint32_t guide, scene::ScreenPoint at) noexcept {
  if (sessions_[part].guide() == guide) part = seating_->other_visitor_at(at, part);
  if (part > 0) handshakes_.wish(part, guide, sessions_, drawn_size(), planner_, crowd_);
}

/// Each contact belongs to the visitor nearest to it.
void Guide::put_down(const input::InputEvent& event) noexcept {
  ++counters_.touches;
  std::erase_if(held_, [&](const Held& held) { return held.contact == event.contact.id; });
  if (wake()) return sessions_[0].overlay().ring(event.contact.x, event.contact.y);
  const scene::ScreenPoint at{event.contact.x, event.contact.y};
  if (held_.size() == held_.capacity()) return;
  if (!seating_) {
    held_.push_back({event.contact.id, 0, 0, scene::Side::Bottom, at});
    return;
  }
  const std::size_t visitor = seating_->visitor_at(at);
  if (visitor == 0) {
    refusal_seconds_ = refusal_shown_for;
    return sessions_[0].overlay().ring(at.x, at.y);
  }
  speaker_ = visitor;
  seating_->touch(visitor, at);
  const std::size_t surface = seating_->is_on_model(at) ? 0 : visitor;
  held_.push_back({event.contact.id, visitor, surface, sessions_[surface].overlay().side(), at});
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
  GuideSettings asked = settings_;
  asked.shape = shape;
  asked.shape.sides = settings_.shape.sides;  // its seats stay
  if (asked.shape == settings_.shape) return;
  settings_.shape = asked.shape;
  light_ = scene::light_of(museum_.livery, settings_.shape.is_night);
  for (Session& session : sessions_) session.request_view();
}

void Guide::take_answers() noexcept {
  while (std::unique_ptr<interface::View> view = planner_.take_view()) {
    const std::size_t part = view->part;
    if (!is_shared() && part == Captions::part) {
      captions_.take(std::move(view));
      continue;
    }
    if (part >= sessions_.size() || !sessions_[part].take_view(std::move(view))) continue;
    ++counters_.views;
    if (part == 0 && !attract_.is_on())
      stage_.enter(sessions_[0].state(), {sessions_[0].view()->free, sessions_[0].view()->boards},
                   interface::aspect_ratio(settings_.shape), leader());
  }
}

void Guide::heed_closures() noexcept {
  crowd_.replan();
  for (Session& session : sessions_) session.heed_closures();
}

// What time brings.

void Guide::step(Seconds dt) noexcept {
  const float seconds = dt.count();
  take_answers();
  attention_.direct(sessions_, settings_.shape,
                    scene::view_of(stage_.rig(), interface::aspect_ratio(settings_.shape)),
                    homes_.size(), settings_.reduced_motion, crowd_);
  const float theirs = keep_still(seconds);
  for (int i = 0; i < pace(); ++i) {
    walk(theirs);
    if (state().skips) follow_chapters(0);
  }
  follow_chapters(seconds);
  go_along_in_time(seconds);
  counters_.routes = 0;
  for (Session& session : sessions_) {
    session.step(seconds, settings_.idle_reset.count(), repose_.share());
    counters_.routes += session.routes();
  }
  video_turns_.share(sessions_);
  if (!is_shared()) captions_.step(sessions_[0], settings_.shape, planner_, seconds);
  refusal_seconds_ = std::max(0.0F, refusal_seconds_ - seconds);
  tell_each_other();
  attract(seconds);
  if (!is_shared()) {
    sessions_[0].look_closer(stage_.whole(), interface::aspect_ratio(settings_.shape), seconds);
    stage_.look_closer(sessions_[0].closer_look());
  }
  stage_.advance(seen(), leader(), seconds);
}

/// While nobody is there. The model then has the whole screen.
void Guide::attract(float seconds) noexcept {
  if (settings_.reduced_motion || view() == nullptr) return;
  const bool was_on = attract_.is_on();
  if (attract_.step(seconds, is_vacant() && !voice().is_busy(), crowd_))
    stage_.enter(
        attract_.state(),
        {interface::is_landscape(settings_.shape) ? scene::Rect{0, 0, 1, 1} : above_welcome, {}},
        interface::aspect_ratio(settings_.shape), leader());
  if (attract_.is_on() && !was_on) let_go();
  if (attract_.has_begun()) strollers_.come(crowd_);
  stage_.sway(attract_.turn(), attract_.further());
}

DrawnSize Guide::drawn_size() const noexcept {
  return {scene::view_of(stage_.rig(), interface::aspect_ratio(settings_.shape)), settings_.shape,
          is_shared()};
}

/// How much of these seconds passes on the model.
float Guide::keep_still(float seconds) noexcept {
  const std::optional<ShownVideo> watched = is_shared() ? std::nullopt : video();
  const bool is_asked = spares_videos_ && watched && watched->plays;
  return seconds * repose_.step(is_asked, leader(), seconds);
}

void Guide::walk(float seconds) noexcept {
  doors_.step(seconds, crowd_);
  if (is_shared()) handshakes_.step(seconds, sessions_, drawn_size(), planner_, crowd_);
  if (touches_) touches_->step(seconds, sessions_, drawn_size(), crowd_);
  crowd_.step(seconds);
  strollers_.step(crowd_);
  counters_.collisions += crowd_.collisions();
  const Agent& guide = crowd_[0];
  if ((is_shared() && !attract_.is_on()) || !guide.is_answered || sessions_[0].ends_aside()) return;
  const plan::Plan& plan = guide.avatar.next ? *guide.avatar.next : *guide.avatar.plan;
  if (plan.order.id == guide.last_order && !plan.points.empty()) stage_.show_way(plan, list_);
}

/// How many times as fast as in reality everybody walks.
int Guide::pace() const noexcept {
  const bool goes_along = !is_shared() && state().screen == interface::Screen::Walking;
  if (!goes_along) return 1;
  return state().skips ? skipping_pace : std::max(1, static_cast<int>(state().pace));
}

void Guide::follow_chapters(float seconds) noexcept {
  if (!is_shared()) sessions_[0].show(chapters_.step(state(), leader(), seconds));
}

/// Whoever has seen the whole way for a while goes along with the guide.
void Guide::go_along_in_time(float seconds) noexcept {
  constexpr float seen_enough = 4;
  if (is_shared() || !interface::shows_whole_way(state())) {
    whole_way_seconds_ = 0;
    return;
  }
  whole_way_seconds_ += seconds;
  if (whole_way_seconds_ < seen_enough) return;
  interface::InterfaceState along = state();
  along.pace = 1;
  sessions_[0].show(along);
}

std::span<const LedVisitor> Guide::led_visitors() noexcept {
  led_visitors_.clear();
  if (const auto led = attract_.led()) led_visitors_.push_back(*led);
  for (const Session& session : sessions_)
    if (session.guide() && session.shows_goal())
      led_visitors_.push_back({*session.guide(), session.state().exhibit,
                               interface::goal_of(museum_, session.state()),
                               session.state().arrived, session.strays()});
  return led_visitors_;
}

/// On a shared glass the model is small, and figures on it are larger than life.
void Guide::draw_bodies() noexcept {
  const scene::CameraView camera =
      scene::view_of(stage_.rig(), interface::aspect_ratio(settings_.shape));
  for (const Agent& one : crowd_.members()) {
    if (!is_to_be_seen(one) || one.avatar.shown_floor != stage_.floor()) continue;
    const std::size_t before = list_.avatars.size();
    draw(museum_, one.avatar, list_);
    if (!is_shared() || list_.avatars.size() == before) continue;
    const Vec3 ground = to_world(one.avatar.body.position, one.avatar.height);
    enlarge_last(ground, stature_scale(camera, settings_.shape, ground), list_);
  }
}

const scene::DrawList& Guide::draw_list() noexcept {
  list_.avatars.clear();
  list_.palette.clear();
  list_.joint.clear();
  list_.quads.clear();
  list_.leaves.clear();
  list_.light = attract_.light(light_);
  draw_bodies();
  doors_.draw(stage_.floor(), list_);
  stage_.draw(seen(), crowd_, led_visitors(), list_);
  const bool is_near =
      seen().screen == interface::Screen::Walking || seen().screen == interface::Screen::Arrived;
  draw_objects(museum_, stage_.floor(), sessions_[0].table(),
               is_near ? seen().exhibit : std::nullopt, list_);
  draw_interface();
  return list_;
}

float Guide::height_of_floor() const noexcept {
  return static_cast<float>(museum_.floors[stage_.floor()].plan.height);
}

interface::Sides Guide::readers() const noexcept {
  const interface::Sides all = settings_.shape.sides;
  if (!is_shared() || !all.is_table()) return {};
  interface::Sides taken;
  for (const Session& session : std::span(sessions_).subspan(1))
    if (!session.is_vacant()) taken.add(interface::side_of(settings_.shape, session.state()));
  return taken.count() > 0 ? taken : all;
}

void Guide::draw_interface() noexcept {
  const float opacity = attract_.interface_opacity();
  sessions_[0].overlay().turn_labels(readers());
  const bool names = is_shared() || interface::shows_spots(state().screen);
  for (Session& session : sessions_) {
    session.overlay().follow(list_.camera, height_of_floor(), session.closer_look().is_moving());
    if (opacity == 0) continue;
    const Avatar& guide = crowd_[session.guide().value_or(0)].avatar;
    session.overlay().draw(static_cast<float>(session.remaining()),
                           names && !stage_.is_flying() ? 1 : 0,
                           {guide.shown_floor, guide.body.position}, list_);
  }
  captions_.draw(list_);
  if (opacity < 1)
    for (scene::Quad& quad : list_.quads) quad.colour.a *= opacity;
  if (view() != nullptr) attract_.draw_welcome(*view(), list_);
}

}  // namespace docent::guide
