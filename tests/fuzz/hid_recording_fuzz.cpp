#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/input/decode_recording.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto recording = docent::input::parse_hid_recording(text, "fuzz.hid");
  if (!recording) return 0;
  const auto csv = docent::input::decode_recording(*recording);
  if (csv && csv->find("report,kind,id,x,y,state\n") != 0) __builtin_trap();
  return 0;
}
