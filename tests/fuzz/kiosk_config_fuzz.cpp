#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "config/kiosk_config.h"
#include "tests/fuzz/scratch_folder.h"

using namespace docent;

namespace {

bool is_within_its_manual(const config::KioskConfig& config) {
  const auto pixels = [](int count) { return count == 0 || (count >= 64 && count <= 16384); };
  const auto is_said_within = [](const auto& said, auto least, auto most) {
    return !said || (*said >= least && *said <= most);
  };
  return config.idle_reset >= std::chrono::seconds(10) &&
         config.idle_reset <= std::chrono::seconds(600) && config.text_scale >= 1 &&
         config.text_scale <= 2 && is_said_within(config.screen_inches, 5.0, 120.0) &&
         is_said_within(config.visitors, 1, 8) && config.rotate >= 0 && config.rotate <= 270 &&
         config.rotate % 90 == 0 && pixels(config.width) && pixels(config.height) &&
         config.keys.size() <= 2;
}

}  // namespace

/// A kiosk.toml in which no mistake was found holds only what its manual allows.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::ScratchFolder folder("kiosk-config");
  const auto file = folder.write("kiosk.toml", {reinterpret_cast<const char*>(data), size});
  const config::Loaded<config::KioskConfig> loaded = config::load_kiosk_config(file);
  for (const Diagnostic& mistake : loaded.diagnostics)
    if (mistake.message.empty() || mistake.file.empty()) __builtin_trap();
  if (loaded.diagnostics.empty() && !(loaded.value && is_within_its_manual(*loaded.value)))
    __builtin_trap();
  return 0;
}
