#include "runtime/guide/manner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/motion/chance.h"
#include "runtime/motion/touch.h"

namespace docent::guide {
namespace {

using motion::Gesture;

constexpr double greeting_seconds = 1.7;
constexpr double looks_while_greeting = 1.2;  ///< Then who walks looks where it goes.
constexpr double waving_seconds = 1.6;
constexpr double waves_again = 20;  ///< Seconds.
constexpr double waves_to = 0.6;    ///< Share of those who pass.
constexpr double first_pointing = 4.5, pointing_seconds = 3.2, pointing_period = 17;
constexpr double telling_seconds = 4.2, telling_period = 9;
constexpr double looks_back_every = 6, looks_back_for = 1.3;
constexpr double straight_enough = 0.3;  ///< Radians of the way ahead, to look back.
constexpr double nearly_done = 2;        ///< Metres, from where on it does not look back.
constexpr double glance_seconds = 2.8;
constexpr double farthest_glance = 0.6;  ///< Radians.

/// What it does with its arms at this moment.
struct Doing {
  Gesture gesture = Gesture::None;
  Vec3 target{};
  double since = 0;
};

/// What is left to chance, each by itself.
enum class Habit : std::uint8_t {
  GlancesAside,
  GlancesUp,
  Minds,
  LooksBack,
  Shoulder,
  Points,
  Tells,
  Waves,
  Count
};

std::uint64_t chance_of(Habit habit, const Manner& manner) noexcept {
  return manner.who * static_cast<std::uint64_t>(Habit::Count) + static_cast<std::uint64_t>(habit);
}

double heading_to(const Bearing& bearing, Vec3 target) noexcept {
  const Vec2 line = to_floor(target) - bearing.body.position;
  return std::remainder(std::atan2(line.y, line.x) - bearing.body.heading, 2 * std::numbers::pi);
}

/// For how long it has been pointing, if it does: at first when it has come, then now and then.
std::optional<double> pointing_for(const Company& company, const Manner& manner) noexcept {
  const double since = manner.clock - manner.shows;
  if (company.calm || since < first_pointing) return since;
  const auto again = motion::occasion_at(since - first_pointing, pointing_period, pointing_seconds,
                                         chance_of(Habit::Points, manner));
  if (!again) return {};
  return again->since;
}

void notice(const Company& company, const Bearing& bearing, Manner& manner) noexcept {
  const bool can_show = company.exhibit && bearing.stands;
  if (!can_show)
    manner.shows = Manner::never;
  else if (manner.shows == Manner::never)
    manner.shows = manner.clock;

  const bool comes_by = company.passer && !manner.has_passer;
  manner.has_passer = company.passer.has_value();
  if (comes_by && !company.calm && manner.clock - manner.waved > waves_again &&
      motion::chance(chance_of(Habit::Waves, manner), ++manner.passed) < waves_to)
    wave_to(*company.passer, manner);
  if (company.passer) manner.waved_to = *company.passer;
}

Doing doing_of(const Company& company, const Manner& manner) noexcept {
  if (holds(manner)) return {};
  const double greeting = manner.clock - manner.greeted;
  if (company.visitor && !company.calm && greeting < greeting_seconds)
    return {Gesture::Wave, *company.visitor, greeting};
  if (company.exhibit && manner.shows != Manner::never)
    if (const auto since = pointing_for(company, manner))
      return {Gesture::Point, *company.exhibit, *since};
  const double waving = manner.clock - manner.waved;
  if (waving < waving_seconds) return {Gesture::Wave, manner.waved_to, waving};
  if (company.visitor && manner.shows != Manner::never)
    if (const auto telling = motion::occasion_at(manner.clock - manner.shows, telling_period,
                                                 telling_seconds, chance_of(Habit::Tells, manner)))
      return {Gesture::Tell, *company.visitor, telling->since};
  return {};
}

/// The arm that is nearer; where neither is, the one it used last.
void choose_side(const motion::Arms& arms, const Bearing& bearing, const Doing& doing,
                 Manner& manner) noexcept {
  const double aside = heading_to(bearing, doing.target);
  if (std::abs(aside) > 0.15 && std::abs(aside) < 3.0)
    manner.side = aside > 0 ? Side::Left : Side::Right;
  if (!arms[manner.side]) manner.side = other(manner.side);
}

/// What it looks at: a point, or a turn of the head.
struct Look {
  std::optional<Vec3> at{};
  double yaw = 0, pitch = 0;
};

/// About, now here, now there.
Look glance(const Manner& manner) noexcept {
  const double yaw =
      motion::kept_for(manner.clock, glance_seconds, 0.3, chance_of(Habit::GlancesAside, manner));
  const double pitch =
      motion::kept_for(manner.clock, glance_seconds, 0.3, chance_of(Habit::GlancesUp, manner));
  return {.yaw = farthest_glance * yaw, .pitch = 0.12 * pitch - 0.05};
}

/// While it shows something: at that, at the visitor, and sometimes about.
Look look_while_showing(const Company& company, const Doing& doing, const Manner& manner) noexcept {
  if (company.calm || !company.visitor) return {.at = company.exhibit};
  if (doing.gesture == Gesture::Point) {
    const bool sees_to_visitor = doing.since > 1.3 && doing.since < 2.7;
    return {.at = sees_to_visitor ? company.visitor : company.exhibit};
  }
  if (doing.gesture == Gesture::Tell) return {.at = company.visitor};
  const auto n = static_cast<std::int64_t>(std::floor(manner.clock / glance_seconds));
  const double mind = motion::chance(chance_of(Habit::Minds, manner), n);
  if (mind < 0.5) return {.at = company.visitor};
  if (mind < 0.8) return {.at = company.exhibit};
  return glance(manner);
}

Look look_while_standing(const Company& company, const Manner& manner) noexcept {
  if (company.calm) return {};
  const auto n = static_cast<std::int64_t>(std::floor(manner.clock / glance_seconds));
  const double mind = motion::chance(chance_of(Habit::Minds, manner), n);
  if (company.visitor && mind < (company.is_used ? 0.55 : 0.25)) return {.at = company.visitor};
  return glance(manner);
}

bool looks_back(const Company& company, const Bearing& bearing, const Manner& manner) noexcept {
  if (!bearing.walks || company.calm || bearing.metres_left < nearly_done ||
      std::abs(bearing.way_ahead) > straight_enough)
    return false;
  return motion::occasion_at(manner.clock, looks_back_every, looks_back_for,
                             chance_of(Habit::LooksBack, manner))
      .has_value();
}

Look look_of(const Company& company, const Bearing& bearing, const Doing& doing,
             const Manner& manner) noexcept {
  if (company.partner) return {.at = company.partner};
  if (doing.gesture == Gesture::Wave && (bearing.stands || doing.since < looks_while_greeting))
    return {.at = doing.target};
  if (manner.shows != Manner::never) return look_while_showing(company, doing, manner);
  if (bearing.stands) return look_while_standing(company, manner);
  if (company.visitor && looks_back(company, bearing, manner)) return {.at = company.visitor};
  return {.yaw = bearing.way_ahead};
}

/// Over which shoulder one looks at what is behind: the one over which one looks already, else now
/// this one, now that.
double over_one_shoulder(double yaw, const Manner& manner) noexcept {
  constexpr double behind = 2.3;
  if (std::abs(yaw) < behind) return yaw;
  const double now = manner.gaze.yaw;
  if (std::abs(now) > 0.2) return std::copysign(yaw, now);
  const auto n = static_cast<std::int64_t>(std::floor(manner.clock / looks_back_every));
  return std::copysign(yaw, motion::chance(chance_of(Habit::Shoulder, manner), n) - 0.5);
}

/// Bends to what a hand is on; who lets go of it comes up again.
void bend(const Skeleton& skeleton, double seconds, Manner& manner,
          motion::PoseView& pose) noexcept {
  constexpr double straightens = 3;  // per second
  if (holds(manner)) {
    manner.bend = {};
    for (const auto& held : manner.held)
      if (held && held->bend.lean >= manner.bend.lean) manner.bend = held->bend;
  } else {
    const auto left = static_cast<float>(std::exp(-straightens * seconds));
    manner.bend.lean *= left;
    manner.bend.turn *= left;
    if (std::abs(manner.bend.lean) + std::abs(manner.bend.turn) < 1e-4F) manner.bend = {};
  }
  motion::bend_trunk(skeleton, manner.bend, pose);
}

}  // namespace

void greet(Manner& manner) noexcept {
  if (manner.clock - manner.greeted > greeting_seconds) manner.greeted = manner.clock;
}

void wave_to(Vec3 whom, Manner& manner) noexcept {
  manner.waved = manner.clock;
  manner.waved_to = whom;
}

void behave(const Skeleton& skeleton, const motion::Arms& arms, const Company& company,
            const Bearing& bearing, double seconds, Manner& manner,
            motion::PoseView& pose) noexcept {
  manner.clock += seconds;
  notice(company, bearing, manner);
  const Doing doing = doing_of(company, manner);
  if (doing.gesture != manner.gesture && doing.gesture != Gesture::None)
    choose_side(arms, bearing, doing, manner);
  manner.gesture = doing.gesture;

  bend(skeleton, seconds, manner, pose);
  const Look look = look_of(company, bearing, doing, manner);
  double yaw = look.yaw, pitch = look.pitch;
  if (look.at) {
    const JointIndex head = skeleton[BodyPart::Head];
    const Vec3 eye = head == JointIndex::None
                         ? to_world(bearing.body.position, bearing.height + 1.5)
                         : motion::place_of(skeleton, head, pose).place;
    const motion::Gaze wish = motion::gaze_at(*look.at, eye, bearing.body.heading);
    yaw = over_one_shoulder(wish.yaw, manner);
    pitch = wish.pitch;
  }
  pitch += static_cast<double>(manner.bend.lean);
  motion::follow_gaze(yaw, pitch, seconds, manner.gaze);
  motion::turn_head(skeleton, manner.gaze, pose);

  for (const Side side : both_sides) {
    if (!arms[side]) continue;
    motion::ArmOrder order;
    if (const auto& held = manner.held[index_of(side)])
      order = {.gesture = Gesture::Hold, .seconds = held->since, .grip = held->grip};
    else if (side == manner.side)
      order = {.gesture = doing.gesture, .target = doing.target, .seconds = doing.since};
    motion::move_arm(skeleton, *arms[side], order, seconds, manner.arm[index_of(side)], pose);
  }
}

}  // namespace docent::guide
