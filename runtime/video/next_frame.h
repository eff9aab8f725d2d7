#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/video/webm.h"

namespace docent::video {

/// What a player decodes next.
struct NextFrame {
  std::size_t index = 0;  ///< Of the video's frames.
  bool is_seen = true;    ///< Else others are made from it, and no more.
};

/// `next`: the first of `frames` that has not been decoded; one of them. `due`: where the video has
/// to be, in milliseconds; `seen`: where it had to be when a frame was last made to be seen, at
/// most `due`. What another frame after it has replaced already is not seen, and what lies before a
/// key frame that is due is left out. A player that comes behind all the same shows what it has,
/// late, some three times a second.
NextFrame next_frame(std::span<const Frame> frames, std::size_t next, std::uint32_t due,
                     std::uint32_t seen) noexcept;

}  // namespace docent::video
