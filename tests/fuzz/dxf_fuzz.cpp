#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "content/content_error.h"
#include "content/import/drawing/read_drawing.h"

using namespace docent;

/// Any bytes: rooms of finite corners, or a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const import::BuildingSource source{"fuzz.dxf",
                                      std::string(reinterpret_cast<const char*>(data), size), ""};
  try {
    const auto building = import::read_dxf(source, {.unit = "m"});
    if (!building) {
      if (building.error().empty() || building.error().front().message.empty()) __builtin_trap();
      return 0;
    }
    for (const import::ImportedLevel& level : building->levels)
      for (const import::ImportedRoom& room : level.rooms)
        for (const import::BuildingRing& ring : room.rings)
          for (const Vec2 corner : ring)
            if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) __builtin_trap();
  } catch (const content::ContentError& error) {
    if (std::string_view(error.what()).empty() || error.code.empty()) __builtin_trap();
  }
  return 0;
}
