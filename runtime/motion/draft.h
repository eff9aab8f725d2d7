#pragma once

#include <array>
#include <optional>
#include <vector>

#include "runtime/motion/clip_sequence.h"
#include "runtime/motion/walk.h"

namespace docent::motion {

/// A part of a walk in the making: poses, and beside them where each foot shall be. The legs of the
/// poses are only nearly right until place_feet().
struct Draft {
  Walk walk;
  std::array<std::vector<Foot>, 2> foot;    ///< Per frame.
  std::array<std::vector<float>, 2> reach;  ///< Per frame: hip to ankle in the motion that the
                                            ///< frame came from, metres; how straight the leg was.
};

Draft empty_draft(const WalkGraph& graph);

/// The pose of a body at a moment and how it moves: what the next part of a walk takes over.
struct Momentum {
  Vec3 root{};
  std::vector<Quat> rotation;
  Vec3 root_velocity{};       ///< Metres a second.
  std::vector<Vec3> turning;  ///< Per joint, radians a second about axes of the parent.
  std::array<Foot, 2> foot;
  std::array<Vec3, 2> foot_velocity{};
  std::array<bool, 2> planted{true, true};
  Placement body;
  Placement body_velocity;  ///< Metres and radians a second.
};

/// Over how many frames a velocity is measured: one frame's noise must not become a swing.
std::uint32_t velocity_frames(double rate) noexcept;

/// At a frame of a walk. Velocities are measured over the frames after it, or at the end over those
/// before it: what goes on from there mostly plays the same clip, so noise cancels out.
Momentum momentum_at(const WalkGraph& graph, const Walk& walk, std::uint32_t frame);

/// Of a body that stands at `body`.
Momentum momentum_of(const WalkGraph& graph, const Stand& stand, const Placement& body);

/// The pose of a frame, borrowed.
PoseView pose_of(Walk& walk, std::size_t frame) noexcept;

/// Bends the first `seconds` of a draft so that its first frame is as the momentum says and moves
/// on as it did (inertialization: Bollo 2018).
void inertialise(const Momentum& momentum, double seconds, Draft& draft);

/// Lowers the hips, smoothly, where a foot would be out of reach. The first frame stays as it is.
void lower_hips(const WalkGraph& graph, Draft& draft);

/// Bends the legs so that every foot is where it shall be.
void place_feet(const WalkGraph& graph, Draft& draft);

/// Appends a finished draft to a walk. Its first frame repeats the walk's last one and is left out,
/// unless the walk is empty.
void append(Draft draft, Walk& walk);

}  // namespace docent::motion
