#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/pixels.h"
#include "runtime/model/result.h"

namespace docent::film {

/// The bytes of an animated WebP file that shows pictures of one size, at least one, each for
/// `seconds`, over and over. The same pictures always give the same bytes.
Result<std::vector<std::byte>> encode_webp(std::span<const Pixels> pictures, double seconds);

}  // namespace docent::film
