#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/motion/motion_clip.h"

/// The frames of a clip as bytes: its `joint_count`, `root`, `rotation` and `plants`.
///
/// A clip that lies on a motion grid (runtime/model/motion/motion_grid.h), as the content
/// compiler's clips do, takes about 5 bits for each number that moves: what two frames before
/// predict is taken off, and the rest is written in Rice's code, whose parameter follows the size
/// of what came before. Joints that keep still cost one bit for 16 frames. Any other clip is
/// written as plain floats. Either way what is decoded is what was encoded, bit for bit, on every
/// machine.
///
///   byte         bits of the grid, 0 for plain floats
///   u32 u32      frames, joints (low byte first, as everywhere in a database)
///   plain        root, rotation and plants, as blob.h writes them
///   on a grid    bits, the high one of a byte first, in blocks of 16 frames (the last may be
///   short):
///     plants       2 bits a frame: left, right
///     root         3 numbers a frame
///     each joint   1 bit: does it turn in these frames? If so, stretches of frames until the block
///                  is full, each of
///                    1 bit: another derived part than before (at first w, positive)? If so, which
///                    (2 bits: x, y, z, w) and its sign (1 bit: negative)
///                    1 bit: does it end before the block does? If so, its frames less one (4 bits)
///                    3 numbers a frame: the other parts, in order
///   to the end of the last byte, zeros.
///
/// A number is the remainder r of a part's steps less their prediction, which is twice the last
/// value less the one before (before the first frame the rotation has no angle and the root is at
/// 0). It is written as u = 2r where r >= 0, else u = -2r - 1. Rice's code: u >> k ones and a zero,
/// then the low k bits; 24 ones and then 64 bits where u >> k is 24 or more. k is the bit width of
/// level >> 4, where each part has its level, 256 at first and then level - (level >> 3) + min(u,
/// 2^20).
///
/// Sources: Rice and Plaunt 1971 (the code); Weinberger, Seroussi, Sapiro 2000 (LOCO-I: a parameter
/// that follows the data); Shoemake 1985 (quaternions).
namespace docent::schema {

/// The clip keeps MotionClip's invariants.
std::vector<std::byte> encode(const MotionClip& clip);

/// Replaces the clip's frames by those that the bytes hold; false, and nothing changed, where they
/// hold none. Safe on any bytes: takes at most a few kilobytes of memory for each of them.
[[nodiscard]] bool decode(std::span<const std::byte> bytes, MotionClip& clip);

}  // namespace docent::schema
