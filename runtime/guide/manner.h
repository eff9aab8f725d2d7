#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "runtime/model/geometry/vec2.h"
#include "runtime/model/motion/side.h"
#include "runtime/motion/gesture.h"
#include "runtime/motion/pose.h"
#include "runtime/motion/touch.h"

namespace docent::guide {

/// Whom and what a body attends to. World frame.
struct Company {
  std::optional<Vec3> visitor{};  ///< Where its visitor looks from.
  bool is_used = false;           ///< The visitor is there, and touches the glass.
  std::optional<Vec3> exhibit{};  ///< What it has led its visitor to.
  std::optional<Vec3> passer{};   ///< Somebody who passes near.
  std::optional<Vec3> partner{};  ///< Whom it meets: it looks at nobody else.
  bool calm = false;  ///< It points at what it has led to, and does nothing for its own sake.
};

/// How a body is on its way at this moment.
struct Bearing {
  Placement body;
  double height = 0;       ///< World y of what it stands on.
  double way_ahead = 0;    ///< Where it will go, from where it faces: radians.
  double metres_left = 0;  ///< Of this part of its way.
  bool stands = true, walks = false;
};

/// A hand that is to be on something.
struct Held {
  motion::Grip grip;
  double since = 0;          ///< Seconds for which it has been sent there.
  motion::TrunkBend bend{};  ///< Of the trunk, to it.
};

/// What a body does besides walking: it greets, looks round to whom it leads, points, waves, and
/// glances about. Chance is a function of the time and of who it is (runtime/motion/chance.h).
struct Manner {
  static constexpr double never = -1e9;
  std::uint64_t who = 0;
  double clock = 0;          ///< Seconds.
  double greeted = never;    ///< When it last began to greet its visitor...
  double shows = never;      ///< ... to show an exhibit: `never` where it does not...
  double waved = never;      ///< ... and to wave to somebody.
  std::uint32_t passed = 0;  ///< How many have passed.
  bool has_passer = false;
  Vec3 waved_to{};
  Side side = Side::Right;  ///< Of the arm that it uses.
  motion::Gesture gesture = motion::Gesture::None;
  motion::Gaze gaze;
  motion::TrunkBend bend{};                   ///< Of its trunk.
  std::array<std::optional<Held>, 2> held{};  ///< By Side. Then neither arm does anything else.
  std::array<motion::ArmMotion, 2> arm{};
};

/// Is a hand of it on something, or on its way there?
inline bool holds(const Manner& manner) noexcept {
  return manner.held[0] || manner.held[1];
}

/// Lifts a hand to its visitor, from the next frame on.
void greet(Manner& manner) noexcept;
/// The same to somebody who waved.
void wave_to(Vec3 whom, Manner& manner) noexcept;

/// One step of time: turns head and arms of a pose as the manner has it. Does not allocate.
void behave(const Skeleton& skeleton, const motion::Arms& arms, const Company& company,
            const Bearing& bearing, double seconds, Manner& manner,
            motion::PoseView& pose) noexcept;

}  // namespace docent::guide
