#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/schema/motion_blob.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  docent::MotionClip clip;
  const bool read = docent::schema::decode(std::as_bytes(std::span(data, size)), clip);
  if (!read) {
    if (!clip.root.empty()) __builtin_trap();
    return 0;
  }
  if (clip.rotation.size() != clip.root.size() * clip.joint_count) __builtin_trap();
  // What was read can be written, and read again as the same.
  const auto written = docent::schema::encode(clip);
  docent::MotionClip again;
  if (!docent::schema::decode(written, again)) __builtin_trap();
  if (docent::schema::encode(again) != written) __builtin_trap();
  return 0;
}
