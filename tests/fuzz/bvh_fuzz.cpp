#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/import/motion/bvh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto motion =
        docent::import::parse_bvh({reinterpret_cast<const char*>(data), size}, "fuzz.bvh", 1.0);
    const auto& clip = motion.clip;
    if (clip.root.empty() || clip.rotation.size() != clip.root.size() * clip.joint_count)
      __builtin_trap();
    if (!std::isfinite(clip.root[0].x)) __builtin_trap();
  } catch (const docent::content::ContentError& error) {
    if (error.code.empty()) __builtin_trap();
  }
  return 0;
}
