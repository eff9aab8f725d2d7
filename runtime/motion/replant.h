#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/motion/draft.h"

namespace docent::motion {

/// Where a foot is and how it moves when a stretch of motion begins.
struct FootStart {
  Foot foot;
  Vec3 velocity{};
};

/// Holds a foot still while it touches the ground. `feet` are its places in the motion, `hips`
/// those of its hip joint, and `contact` says when its toe joint rests on the ground; each foot
/// plant gets one place (its own mean, or `start` where it goes on from there), level ground and
/// one heading. Between foot plants the difference is bridged by a curve without kinks, so that the
/// foot leaves and lands as it did. A foot plant out of the leg's reach is cut short: the foot is
/// lifted earlier. Each place but the first and the last is a little off, as no two steps of a
/// person are alike: by what `seed` says.
void replant(const WalkGraph& graph, Side side, std::span<Foot> feet, std::span<const Vec3> hips,
             std::vector<bool>& contact, const FootStart& start, bool starts_planted,
             std::uint32_t seed);

/// How far a hip joint must sink for the ankle to be within `reach` of it, metres; 0 where the
/// ankle is within reach already.
float drop_into_reach(Vec3 hip, Vec3 ankle, float reach) noexcept;

/// The heading of a foot from ankle to toe (floor frame, radians).
double foot_heading(const Leg& leg, const Foot& foot) noexcept;

}  // namespace docent::motion
