#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "content/content_error.h"
#include "content/import/building/imported_building.h"

namespace docent::test {

/// What a reader of one format must make of any bytes: rooms of finite corners, or a sentence.
void expect_rooms_or_sentence(const std::uint8_t* data, std::size_t size, const char* file,
                              const auto& read) {
  const import::BuildingSource source{file, std::string(reinterpret_cast<const char*>(data), size),
                                      ""};
  try {
    const auto building = read(source);
    if (!building) {
      if (building.error().empty() || building.error().front().message.empty()) __builtin_trap();
      return;
    }
    for (const import::ImportedLevel& level : building->levels)
      for (const import::ImportedRoom& room : level.rooms)
        for (const import::BuildingRing& ring : room.rings)
          for (const Vec2 corner : ring)
            if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) __builtin_trap();
  } catch (const content::ContentError& error) {
    if (std::string_view(error.what()).empty() || error.code.empty()) __builtin_trap();
  }
}

}  // namespace docent::test
