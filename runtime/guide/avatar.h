#pragma once

#include <memory>
#include <vector>

#include "runtime/guide/manner.h"
#include "runtime/model/museum.h"
#include "runtime/motion/cloth.h"
#include "runtime/motion/idle.h"
#include "runtime/motion/pose.h"
#include "runtime/plan/plan.h"
#include "runtime/scene/draw_list.h"

namespace docent::guide {

/// What an avatar does, as states.csv names it.
enum class AvatarState : std::uint8_t { Idle, Turn, Walk, Wait, Look, Gesture };

/// A body that is drawn: the plan that it walks, and its pose at this moment.
struct Avatar {
  std::uint32_t floor = 0;
  std::uint32_t look = 0;            ///< Of `looks` (runtime/scene/look.h).
  std::unique_ptr<plan::Plan> plan;  ///< Never empty; once over, it stands at the last frame.
  std::unique_ptr<plan::Plan> next;  ///< Takes over at frame next->order.previous_frame of `plan`.
  double seconds = 0;                ///< Since the first frame of plan's walk.
  double standing = 0;     ///< Seconds that it has stood; keeps its value while it sets out...
  double idle_weight = 1;  ///< ... and this fades the idle motion out.
  bool breathes = true;    ///< False: it stands as still as at the first moment, and its clothes
                           ///< and hair move only as its body does.
  Placement body;
  double height = 0;              ///< World y of what it stands on, metres.
  std::uint32_t shown_floor = 0;  ///< On which it is seen: half way along a ride, the next one.
  motion::Climb ground;           ///< On a flight: how high above `floor` it has come; else 0.
  Vec2 aside{};                   ///< Of a carried body: from its place in the plan's walk.
  double along = 0;               ///< Metres of the plan's way behind it.
  motion::Gait gait = motion::Gait::Idle;
  Company company;  ///< Whom it attends to.
  Manner manner;    ///< What it does besides walking.

  motion::Limbs limbs;
  std::vector<Quat> rotation;  ///< One per joint.
  std::vector<Mat4> world;     ///< One per joint, world frame.
  /// What its body is drawn with (matrices_of): joints, then cloth. World frame.
  std::vector<Mat4> palette;
  motion::ClothMotion cloth;
  std::size_t dressed_as = 0;          ///< The body whose cloth that is.
  float ankle_rest = 0, toe_rest = 0;  ///< Height of the joints when standing flat.
};

/// An avatar that stands as the plan `standing` does. Allocates all that it will ever need.
/// `who`: no two of a crowd have the same habits.
Avatar make_avatar(const Museum& museum, std::uint32_t floor, std::unique_ptr<plan::Plan> standing,
                   std::uint64_t who = 0);

/// The ride that it is on; null where it is on its floor.
const plan::Ride* ride_of(const Avatar& avatar) noexcept;
/// How far it is along its ride, or 0: 0 to 1.
double ride_share(const Museum& museum, const Avatar& avatar) noexcept;

/// A body is drawn so much higher than its skeleton is, from the ground.
float build_of(const Avatar& avatar) noexcept;

/// Is it at the end of its plan?
bool has_finished(const Avatar& avatar) noexcept;

/// Where its plans will have it some seconds from now.
Placement place_ahead(const Avatar& avatar, double seconds) noexcept;

/// The frame of the plan's walk from which a new plan can take over, `lead` seconds from now.
std::uint32_t frame_ahead(const Avatar& avatar, double lead) noexcept;

/// Hands the avatar a plan that takes over at a frame of the one before (see frame_ahead). False
/// where that frame has passed already: then a plan has to be asked for again.
bool take_plan(Avatar& avatar, std::unique_ptr<plan::Plan> plan) noexcept;

/// One step of time: follows the plan, changes to the next at its frame, poses the body.
void advance(const Museum& museum, Avatar& avatar, double seconds) noexcept;

/// Appends the avatar to a draw list.
void draw(const Museum& museum, const Avatar& avatar, scene::DrawList& list) noexcept;

}  // namespace docent::guide
