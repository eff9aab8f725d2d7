#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/pixels.h"

namespace docent::object {

/// How much of each pixel a thing covers, of 255. Rows from the top; nothing at its borders.
struct Mask {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> cover;
};

/// A thing without the ground that it was photographed on.
struct CutOut {
  Mask mask;                     ///< One piece, with such holes as are large.
  Pixels picture;                ///< As large; opaque: where the mask ends its colours go on.
  std::size_t other_pieces = 0;  ///< Left out.
};

/// Cuts out what a picture shows: what is not clear, or where nothing is clear, what differs from
/// the one colour of its edges. Of several pieces the largest is taken. ContentError
/// (`busy-picture`) about `file` where its ground is neither clear nor of one colour, where it
/// shows nothing, or nothing else than its ground.
CutOut cut_out(const Pixels& picture, const std::string& file);

}  // namespace docent::object
