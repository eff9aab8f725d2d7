#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/import/motion/amc.h"

/// An ASF, a line of four minus signs, and an AMC.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view parting = "\n----\n";
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t middle = std::min(text.find(parting), text.size());
  try {
    const auto skeleton = docent::import::parse_asf(text.substr(0, middle), "fuzz.asf");
    const std::string_view rest = text.substr(std::min(middle + parting.size(), text.size()));
    const auto motion = docent::import::parse_amc(rest, "fuzz.amc", skeleton);
    if (motion.clip.rotation.size() != motion.clip.root.size() * motion.skeleton.joint.size())
      __builtin_trap();
  } catch (const docent::content::ContentError& error) {
    if (error.code.empty()) __builtin_trap();
  }
  return 0;
}
