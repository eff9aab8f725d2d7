#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "runtime/model/result.h"

namespace docent {

/// A decoded picture: rows from the top, four bytes a pixel (sRGB red, green, blue and straight
/// alpha). Invariant: rgba.size() == 4 * width * height.
struct Pixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::byte> rgba;
};

/// What a picture may be at most; a larger one is refused before its memory is taken.
struct ImageLimits {
  std::uint32_t side = 8192;          ///< Pixels.
  std::uint64_t pixels = 32'000'000;  ///< Width times height.
};

/// Decodes the bytes of a PNG or JPEG file. Any bytes are safe: what is broken, cut short, too
/// large or of another kind is answered with a sentence.
Result<Pixels> decode_image(std::span<const std::byte> file, const ImageLimits& limits = {});

/// The size of a PNG or JPEG from its header alone: width and height set, no pixels.
Result<Pixels> read_image_size(std::span<const std::byte> file, const ImageLimits& limits = {});

/// The picture made smaller, so that no side is longer than `longest_side`: box filter in linear
/// light. A picture that is small enough comes back as it is.
Pixels shrink(Pixels picture, std::uint32_t longest_side);

/// The bytes of a PNG file: 8-bit RGBA, or RGB where every pixel is opaque. The same pixels always
/// give the same bytes.
Result<std::vector<std::byte>> encode_png(const Pixels& picture);

/// Writes a PNG file whole or not at all: a temporary file beside it, then a rename.
Result<void> write_png(const std::filesystem::path& file, const Pixels& picture);

}  // namespace docent
