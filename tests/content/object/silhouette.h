#pragma once

#include <cstdint>
#include <vector>

#include "content/object/shape.h"

namespace docent::test {

/// How far apart two shapes' outlines are at most, in pixels, seen from `views` places round them
/// on a screen of 1920 by 1080 that the first one fills.
float silhouette_error(const object::Shape& shape, const object::Shape& other, int views);

}  // namespace docent::test
