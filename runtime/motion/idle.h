#pragma once

#include <cstdint>
#include <optional>

#include "runtime/motion/arm.h"
#include "runtime/motion/leg.h"
#include "runtime/motion/pose.h"

namespace docent::motion {

/// A skeleton's legs and arms, found once.
struct Limbs {
  std::optional<Legs> legs;
  Arms arms;
};
Limbs find_limbs(const Skeleton& skeleton);

/// How a body stands.
struct Standing {
  double seconds = 0;     ///< Since it began to; nothing is added at 0.
  double weight = 1;      ///< Less than 1 while it sets out.
  std::uint64_t who = 0;  ///< Nobody stands like another.
};

/// Adds what keeps a standing body alive: breath, shifts of weight from leg to leg over planted
/// feet, hands that do not quite rest. A function of its arguments alone, which never repeats.
/// Smooth; moves the hips by at most 6 cm. Does not allocate.
void add_idle(const Skeleton& skeleton, const Limbs& limbs, const Standing& standing,
              PoseView& pose) noexcept;

}  // namespace docent::motion
