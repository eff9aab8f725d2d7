#include "runtime/video/next_frame.h"

namespace docent::video {

NextFrame next_frame(std::span<const Frame> frames, std::size_t next, std::uint32_t due,
                     std::uint32_t seen) noexcept {
  constexpr std::uint32_t longest_still = 300;
  NextFrame one{.index = next};
  for (std::size_t i = next + 1; i < frames.size() && frames[i].milliseconds <= due; ++i)
    if (frames[i].is_key) one.index = i;
  const bool is_late = one.index + 1 < frames.size() && frames[one.index + 1].milliseconds <= due;
  one.is_seen = !is_late || due - seen > longest_still;
  return one;
}

}  // namespace docent::video
