#include "runtime/guide/attract.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "runtime/interface/goal.h"
#include "runtime/scene/theme.h"

namespace docent::guide {
namespace {

constexpr float alone_after = 60;      ///< Seconds without a touch.
constexpr double first_rest = 6;       ///< Seconds until the guide sets out for the first time, ...
constexpr double rest = 18;            ///< ... and between two ways.
constexpr double overlooked_for = 5;   ///< Seconds that the whole way is seen from above.
constexpr double looks_for = 8;        ///< Seconds at the goal.
constexpr double longest_phase = 240;  ///< Seconds: whatever keeps the guide, it goes home then.
constexpr double day = 48;             ///< Seconds from one bright light to the next.
constexpr double turn_period = 62,
                 breath = 41;            ///< Seconds: of the camera's turn and of its distance.
constexpr double widest_turn = 0.16;     ///< Radians.
constexpr double deepest_breath = 0.06;  ///< Share of the camera's distance.
constexpr double goes_in = 1.5;          ///< Seconds in which the interface makes way.
constexpr double stays = 14;             ///< Seconds that the welcome is at one place.
constexpr double comes_in = 1.2;         ///< Seconds in which it comes there, and goes.

/// Where the middle of the welcome is, as shares of the screen: never where it has just been, and
/// beside whoever walks in the middle.
constexpr std::array<scene::Rect, 4> places{{
    {.x = 0.19F, .y = 0.86F},
    {.x = 0.83F, .y = 0.88F},
    {.x = 0.17F, .y = 0.80F},
    {.x = 0.81F, .y = 0.82F},
}};

double wave(double seconds, double period) noexcept {
  return std::sin(2 * std::numbers::pi * seconds / period);
}

scene::Colour times(const scene::Colour& colour, float r, float g, float b) noexcept {
  return {colour.r * r, colour.g * g, colour.b * b, colour.a};
}

/// The sun is low and warm, the sky blue, and the paper in shade.
scene::Light evening(const scene::Light& usual) noexcept {
  return {.sun = times(usual.sun, 0.62F, 0.44F, 0.30F),
          .sky = times(usual.sky, 0.46F, 0.50F, 0.62F),
          .bounce = times(usual.bounce, 0.50F, 0.46F, 0.46F),
          .paper = times(usual.paper, 0.36F, 0.34F, 0.35F),
          .mark = usual.mark,
          .lamp = usual.lamp,
          .least_way = usual.least_way};
}

/// Exhibits on the kiosk's floor are shown; where there are none, any.
bool may_be_shown(const Museum& museum, std::uint32_t exhibit) noexcept {
  const auto is_near = [&](const Exhibit& one) { return one.floor == museum.kiosk_floor; };
  return is_near(museum.exhibits[exhibit]) || std::ranges::none_of(museum.exhibits, is_near);
}

}  // namespace

bool Attract::wake() noexcept {
  alone_ = 0;
  const bool was_on = is_on();
  phase_ = Phase::Off;
  return was_on;
}

void Attract::enter(Phase phase) noexcept {
  phase_ = phase;
  phase_seconds_ = 0;
}

void Attract::begin(Crowd& crowd) noexcept {
  seconds_ = 0;
  state_ = {};
  enter(Phase::Rests);
  // Among those who come now its place has to be kept, as theirs are.
  crowd.appear(0, museum_.kiosk_floor, museum_.kiosk);
}

/// The next exhibit is far from the last one in the list, and all have their turn.
void Attract::choose(Crowd& crowd) noexcept {
  const auto count = static_cast<std::uint32_t>(museum_.exhibits.size());
  if (count == 0) return enter(Phase::Rests);
  std::uint32_t step = std::max(1U, static_cast<std::uint32_t>(0.618 * count));
  while (std::gcd(step, count) != 1) ++step;
  do chosen_ = (chosen_ + step) % count;
  while (!may_be_shown(museum_, chosen_));
  const Exhibit& exhibit = museum_.exhibits[chosen_];
  crowd.send(0, exhibit.floor, exhibit.viewing_point, RouteKind::Shortest, {}, chosen_);
  enter(Phase::Asks);
}

void Attract::go_on(Crowd& crowd) noexcept {
  const Agent& guide = crowd[0];
  const bool is_there = guide.has_arrived && !guide.awaits_answer && stands(guide.avatar);
  switch (phase_) {
    case Phase::Off:
      return;
    case Phase::Rests:
      if (phase_seconds_ >= (seconds_ < rest ? first_rest : rest)) choose(crowd);
      return;
    case Phase::Asks:
      if (!guide.route_summary) {
        if (phase_seconds_ >= longest_phase) enter(Phase::Rests);
        return;
      }
      if (guide.route_summary->status != path::RouteStatus::Ok) return enter(Phase::Rests);
      state_ = {.screen = interface::Screen::Walking, .exhibit = chosen_};
      return enter(Phase::Overlooks);
    case Phase::Overlooks:
      if (phase_seconds_ < overlooked_for && !is_there) return;
      state_.pace = 1;
      return enter(Phase::Walks);
    case Phase::Walks:
      if (!is_there && phase_seconds_ < longest_phase) return;
      state_.arrived = true;
      state_.screen = interface::Screen::Arrived;
      return enter(Phase::Looks);
    case Phase::Looks:
      if (phase_seconds_ < looks_for) return;
      state_ = {};
      crowd.send(0, museum_.kiosk_floor, museum_.kiosk, RouteKind::Shortest);
      return enter(Phase::Returns);
    case Phase::Returns:
      if (is_there || phase_seconds_ >= longest_phase) enter(Phase::Rests);
  }
}

bool Attract::step(float seconds, bool is_vacant, Crowd& crowd) noexcept {
  if (!is_vacant) alone_ = 0;
  alone_ += seconds;
  if (!is_on()) {
    if (alone_ < alone_after) return false;
    begin(crowd);
    return true;
  }
  seconds_ += static_cast<double>(seconds);
  phase_seconds_ += static_cast<double>(seconds);
  const interface::InterfaceState before = state_;
  go_on(crowd);
  return state_ != before;
}

std::optional<LedVisitor> Attract::led() const noexcept {
  if (!is_on() || !state_.exhibit) return {};
  return LedVisitor{0, state_.exhibit, interface::goal_of(museum_, state_), state_.arrived};
}

scene::Light Attract::light(const scene::Light& usual) const noexcept {
  if (!is_on()) return usual;
  const double share = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * seconds_ / day);
  return scene::mixed(usual, evening(usual), static_cast<float>(share));
}

double Attract::turn() const noexcept {
  return is_on() ? widest_turn * wave(seconds_, turn_period) : 0;
}

double Attract::further() const noexcept {
  return is_on() ? 1 + deepest_breath * wave(seconds_, breath) : 1;
}

float Attract::interface_opacity() const noexcept {
  return is_on() ? static_cast<float>(1 - scene::smooth_step(seconds_ / goes_in)) : 1;
}

void Attract::draw_welcome(const interface::View& view, scene::DrawList& list) const noexcept {
  const double since = seconds_ - goes_in;
  if (!is_on() || since < 0) return;
  const double here = std::fmod(since, stays);
  const auto opacity = static_cast<float>(scene::smooth_step(here / comes_in) *
                                          scene::smooth_step((stays - here) / comes_in));
  float left = 1, top = 1, right = 0, bottom = 0;
  for (const interface::Element& element : view.elements) {
    if (!element.greets) continue;
    const scene::Rect& at = element.quad.rect;
    left = std::min(left, at.x);
    top = std::min(top, at.y);
    right = std::max(right, at.x + at.width);
    bottom = std::max(bottom, at.y + at.height);
  }
  const scene::Rect& place = places[static_cast<std::size_t>(since / stays) % places.size()];
  const float wide = 4 * view.unit_px / view.pixel_width,
              high = 3 * view.unit_px / view.pixel_height;
  const auto inside = [](float middle, float extent) {
    return std::clamp(middle, 0.5F * extent, std::max(0.5F * extent, 1 - 0.5F * extent));
  };
  if (right <= left || list.quads.size() == list.quads.capacity()) return;
  const float across = right - left + 2 * wide, down = bottom - top + 2 * high;
  scene::Quad board;
  board.rect = {inside(place.x, across + wide) - 0.5F * across,
                inside(place.y, down + high) - 0.5F * down, across, down};
  board.colour = scene::with_opacity(view.theme.paper, opacity);
  board.corner = 1.5F / 135;
  list.quads.push_back(board);
  for (const interface::Element& element : view.elements) {
    if (!element.greets || list.quads.size() == list.quads.capacity()) continue;
    scene::Quad quad = element.quad;
    quad.rect.x += board.rect.x + wide - left;
    quad.rect.y += board.rect.y + high - top;
    quad.colour = scene::with_opacity(quad.colour, opacity);
    list.quads.push_back(quad);
  }
}

}  // namespace docent::guide
