#pragma once

#include <cstdint>
#include <vector>

#include "platform/gles/body.h"
#include "platform/gles/building.h"
#include "platform/gles/holdings.h"
#include "platform/gles/object_shape.h"
#include "platform/gles/textures.h"

namespace docent::gles {

/// What the passes draw from.
struct Holdings::Parts {
  Textures textures;
  std::vector<Building> buildings;  ///< By floor.
  Body body;
  Objects objects;

  /// Null where the floor has none.
  const Building* building(std::uint32_t floor) const noexcept {
    return floor < buildings.size() && buildings[floor].array ? &buildings[floor] : nullptr;
  }
};

}  // namespace docent::gles
