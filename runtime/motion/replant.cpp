#include "runtime/motion/replant.h"

#include <algorithm>
#include <cmath>

#include "runtime/model/motion/variation.h"
#include "runtime/motion/placement.h"
#include "runtime/motion/rotation.h"
#include "runtime/motion/smoothing.h"

namespace docent::motion {
namespace {

/// What a foot's own motion must be moved by: place, and heading about the vertical.
struct Shift {
  Vec3 place{};
  float heading = 0;
};

Shift operator+(Shift a, Shift b) noexcept {
  return {a.place + b.place, a.heading + b.heading};
}
Shift operator-(Shift a, Shift b) noexcept {
  return {a.place - b.place, a.heading - b.heading};
}
Shift operator*(float s, Shift a) noexcept {
  return {s * a.place, s * a.heading};
}

/// Hermite's cubic between two values with given slopes (per unit of t).
Shift hermite(Shift from, Shift from_slope, Shift to, Shift to_slope, float t) noexcept {
  const float u = 1 - t;
  return (u * u * (1 + 2 * t)) * from + (u * u * t) * from_slope + (t * t * (1 + 2 * u)) * to +
         (-t * t * u) * to_slope;
}

struct Contact {
  std::size_t first = 0, end = 0;  ///< Frames [first, end).
  Vec3 anchor{};                   ///< Where the toe joint stays.
  float heading = 0;
  float rise = 0;  ///< Levels the ground: the toe keeps its own movement up and down, which is
                   ///< the foot's rolling.
};

constexpr float take_over_seconds = 0.3f;
constexpr float steering_seconds =
    0.3f;  // before landing, in which a foot can still be led elsewhere
constexpr float settled_seconds =
    0.6f;                           // after which a motion that goes on from another is its own
constexpr float free_twist = 0.3f;  // radians between foot and body that a leg takes easily
constexpr float twist_give = 0.2f;  // radians over which the foot begins to turn on its ball
constexpr float hip_give = 0.09f;   // metres that hips sink at most to let a foot stay

class Replanting {
 public:
  Replanting(const WalkGraph& graph, Side side, std::span<Foot> feet)
      : leg_(graph.legs[side]),
        rest_(graph.toe_height[index_of(side)]),
        rate_(static_cast<float>(graph.frame_rate)),
        feet_(feet),
        shift_(feet.size()),
        heading_(feet.size()) {
    std::vector<double> headings(feet.size());
    for (std::size_t f = 0; f < feet.size(); ++f) headings[f] = foot_heading(leg_, feet[f]);
    unwrap_angles(headings);
    std::transform(headings.begin(), headings.end(), heading_.begin(),
                   [](double h) { return static_cast<float>(h); });
  }

  void find_contacts(const std::vector<bool>& contact) {
    for (std::size_t f = 0; f < contact.size();) {
      std::size_t end = f;
      while (end < contact.size() && contact[end] == contact[f]) ++end;
      if (contact[f]) contacts_.push_back(anchored(f, end));
      f = end;
    }
  }

  /// Sets feet down a little off, lengthwise and to the side: standard deviations of healthy adults
  /// (Owings and Grabiner 2004), of which each of two feet has its share. One that begins or ends
  /// standing stays.
  void vary(Side side, std::uint32_t seed) {
    enum Purpose : std::uint32_t { Along, Aside, Facing, Purposes };
    constexpr double along = 0.012, aside = 0.008, facing = 0.022;  // metres, radians
    constexpr double farthest = 1.8;                                // standard deviations
    const auto off = [&](std::size_t step, std::uint32_t purpose) {
      const auto own = purpose + Purposes * static_cast<std::uint32_t>(index_of(side));
      return std::clamp(fluctuation(seed, static_cast<std::int64_t>(step), own), -farthest,
                        farthest);
    };
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      Contact& c = contacts_[k];
      if (static_cast<float>(c.first) < rate_ * settled_seconds || c.end == feet_.size()) continue;
      const Vec2 way =
          turned({along * off(k, Along), aside * off(k, Aside)}, static_cast<double>(c.heading));
      c.anchor += to_world(way, 0);
      c.heading += static_cast<float>(facing * off(k, Facing));
    }
  }

  void start_from(const FootStart& start, bool planted) {
    first_rotation_ = start.foot.rotation;
    if (planted && !contacts_.empty() && contacts_.front().first == 0) {
      contacts_.front().anchor = start.foot.toe;
      contacts_.front().rise = start.foot.toe.y - feet_.front().toe.y;
      contacts_.front().heading = start_heading(start.foot);
      return;
    }
    // The heading of a foot that hangs down means nothing, so only its rotation is taken over.
    begin_ = {start.foot.toe - feet_.front().toe, 0};
    const std::size_t span = std::min<std::size_t>(velocity_frames(rate_), feet_.size() - 1);
    const Vec3 own =
        span > 0 ? (feet_[span].toe - feet_[0].toe) * (rate_ / static_cast<float>(span)) : Vec3{};
    begin_slope_ = {start.velocity - own, 0};
    if (!contacts_.empty()) land_soon(contacts_.front());
  }

  void release_out_of_reach(std::span<const Vec3> hips, std::vector<bool>& contact) {
    for (Contact& c : contacts_) {
      const auto in_reach = [&](std::size_t f) {
        Foot foot{Vec3(c.anchor.x, feet_[f].toe.y + c.rise, c.anchor.z), feet_[f].rotation};
        foot.rotation = world_rotation(heading_in(c, f) - heading_[f]) * foot.rotation;
        return drop_into_reach(hips[f], ankle_of(leg_, foot), 0.998f * leg_.length) < hip_give;
      };
      const std::size_t middle = (c.first + c.end) / 2;
      std::size_t end = middle, first = middle;
      while (end < c.end && in_reach(end)) ++end;
      while (first > c.first && in_reach(first - 1)) --first;
      for (std::size_t f = c.first; f < c.end; ++f) contact[f] = f >= first && f < end;
      c.first = first;
      c.end = end;
    }
    std::erase_if(contacts_, [](const Contact& c) { return c.first == c.end; });
  }

  void apply() {
    for (const Contact& c : contacts_)
      for (std::size_t f = c.first; f < c.end; ++f) {
        shift_[f] = shift_to(c.anchor, heading_in(c, f), f);
        shift_[f].place.y = c.rise;
      }
    bridge_gaps();
    for (std::size_t f = 0; f < feet_.size(); ++f) {
      feet_[f].toe += shift_[f].place;
      feet_[f].rotation = world_rotation(shift_[f].heading) * feet_[f].rotation;
    }
    take_over_rotation();
    keep_above_ground();
  }

 private:
  float start_heading(const Foot& foot) const {
    const auto own = static_cast<double>(heading_.front());
    return static_cast<float>(own + wrap_angle(foot_heading(leg_, foot) - own));
  }

  /// A planted foot keeps its heading, but turns on its ball where the body above it turns further
  /// than a leg can be twisted.
  float heading_in(const Contact& contact, std::size_t f) const {
    const float twist = heading_[f] - contact.heading, over = std::abs(twist) - free_twist;
    if (over <= 0) return contact.heading;
    return contact.heading + std::copysign(over * over / (over + twist_give), twist);
  }

  Shift shift_to(Vec3 place, float heading, std::size_t f) const {
    return {place - feet_[f].toe, heading - heading_[f]};
  }

  /// A foot that is about to land lands where it is about to: there is no time to reach the place
  /// of its own motion.
  void land_soon(Contact& contact) const {
    const float time = static_cast<float>(contact.first) / (rate_ * steering_seconds);
    const float share = std::max(0.0f, 1 - time);
    const Vec3 there = feet_[contact.first].toe + begin_.place;
    contact.anchor = glm::mix(contact.anchor, Vec3(there.x, contact.anchor.y, there.z), share);
    contact.rise = glm::mix(contact.rise, begin_.place.y, share);
    contact.heading = glm::mix(contact.heading, heading_[contact.first], share);
  }

  /// A contact's place: the mean over its middle half, where the foot is flat.
  Contact anchored(std::size_t first, std::size_t end) const {
    Contact c{first, end, {}, 0, 0};
    const std::size_t quarter = (end - first) / 4;
    Vec3 sum{};
    float heading = 0, count = 0;
    for (std::size_t f = first + quarter; f < end - quarter; ++f, ++count) {
      sum += feet_[f].toe;
      heading += heading_[f];
    }
    c.anchor = sum / count;
    c.rise = rest_ - c.anchor.y;
    c.heading = heading / count;
    return c;
  }

  /// The slope of the shift just inside a contact, per second: minus the foot's own motion, which
  /// the pin cancels. Bounded, so that a foot that was still sliding does not fling the swing.
  Shift slope(std::size_t a, std::size_t b) const {
    if (a == b) return {};
    Shift s = (rate_ / static_cast<float>(b - a)) * (shift_[b] - shift_[a]);
    const float speed = glm::length(s.place);
    if (speed > 0.5f) s.place *= 0.5f / speed;
    s.heading = std::clamp(s.heading, -2.0f, 2.0f);
    return s;
  }

  void bridge_gaps() {
    if (contacts_.empty()) {
      for (std::size_t f = 0; f < shift_.size(); ++f) shift_[f] = begin_;
      return;
    }
    constexpr std::size_t span = 3;
    if (const Contact& next = contacts_.front(); next.first > 0)
      bridge(0, next.first, begin_, begin_slope_,
             slope(next.first, std::min(next.first + span, next.end - 1)));
    for (std::size_t i = 1; i < contacts_.size(); ++i) {
      const Contact &last = contacts_[i - 1], &next = contacts_[i];
      const std::size_t a = last.end - 1;
      bridge(a, next.first, shift_[a], slope(a - std::min(span, a - last.first), a),
             slope(next.first, std::min(next.first + span, next.end - 1)));
    }
    const std::size_t after = contacts_.back().end;
    for (std::size_t f = after; f < shift_.size(); ++f) shift_[f] = shift_[after - 1];
  }

  /// Fills the shifts of frames [from, to) from a value and slope at `from` to those at `to`.
  void bridge(std::size_t from, std::size_t to, Shift start, Shift start_slope, Shift end_slope) {
    const float seconds = static_cast<float>(to - from) / rate_;
    for (std::size_t f = from; f < to; ++f) {
      const float t = static_cast<float>(f - from) / static_cast<float>(to - from);
      shift_[f] = hermite(start, seconds * start_slope, shift_[to], seconds * end_slope, t);
    }
  }

  /// What is left between the foot's rotation at the beginning and its own fades within a step.
  void take_over_rotation() {
    const Vec3 left = rotation_vector(first_rotation_ * glm::inverse(feet_.front().rotation));
    const float frames = take_over_seconds * rate_;
    for (std::size_t f = 0; f < feet_.size() && static_cast<float>(f) < frames; ++f) {
      const float t = static_cast<float>(f) / frames;
      const float share = 1 - t * t * t * (10 - t * (15 - 6 * t));
      feet_[f].rotation = glm::normalize(rotation_of(share * left) * feet_[f].rotation);
    }
  }

  void keep_above_ground() {
    for (Foot& foot : feet_) foot.toe.y = std::max(foot.toe.y, rest_ - 0.02f);
  }

  const Leg& leg_;
  float rest_, rate_;
  std::span<Foot> feet_;
  std::vector<Shift> shift_;
  std::vector<float> heading_;  ///< Of the feet in their own motion, unwrapped.
  std::vector<Contact> contacts_;
  Shift begin_, begin_slope_;
  Quat first_rotation_{1, 0, 0, 0};
};

}  // namespace

float drop_into_reach(Vec3 hip, Vec3 ankle, float reach) noexcept {
  const Vec3 apart = hip - ankle;
  const float across = apart.x * apart.x + apart.z * apart.z;
  if (across >= reach * reach) return apart.y;
  return std::max(0.0f, apart.y - std::sqrt(reach * reach - across));
}

double foot_heading(const Leg& leg, const Foot& foot) noexcept {
  const Vec2 forwards = to_floor(foot.rotation * leg.ankle_to_toe);
  return std::atan2(forwards.y, forwards.x);
}

void replant(const WalkGraph& graph, Side side, std::span<Foot> feet, std::span<const Vec3> hips,
             std::vector<bool>& contact, const FootStart& start, bool starts_planted,
             std::uint32_t seed) {
  if (feet.empty()) return;
  Replanting work(graph, side, feet);
  work.find_contacts(contact);
  work.vary(side, seed);
  work.start_from(start, starts_planted);
  work.release_out_of_reach(hips, contact);
  work.apply();
}

}  // namespace docent::motion
