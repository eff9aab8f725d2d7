#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/speech/recording.h"

/// A recording of anybody's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto sound = docent::speech::read_sound(
        std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    if (sound.samples.empty() || sound.rate < docent::speech::least_rate) __builtin_trap();
    for (const float sample : sound.samples)
      if (!(std::abs(sample) <= 1.001F)) __builtin_trap();
  } catch (const docent::content::ContentError& error) {
    if (error.code.empty()) __builtin_trap();
  }
  return 0;
}
