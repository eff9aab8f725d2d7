#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "runtime/model/pixels.h"
#include "runtime/model/result.h"

namespace docent::image {

/// What a picture may be at most; a larger one is refused before its memory is taken.
struct ImageLimits {
  std::uint32_t side = 8192;          ///< Pixels.
  std::uint64_t pixels = 32'000'000;  ///< Width times height.
};

/// Decodes the bytes of a PNG or JPEG file. Any bytes are safe: what is broken, cut short, too
/// large or of another kind is answered with a sentence.
Result<Pixels> decode_image(std::span<const std::byte> file, const ImageLimits& limits = {});

/// Likewise, for a picture that will be shrunk: where that is quicker, a half, a quarter or an
/// eighth of the picture's size, with a longest side of `least_side` pixels or more.
Result<Pixels> decode_at_least(std::span<const std::byte> file, std::uint32_t least_side);

/// The size of a PNG or JPEG from its header alone: width and height set, no pixels.
Result<Pixels> read_image_size(std::span<const std::byte> file, const ImageLimits& limits = {});

/// The picture made smaller, so that no side is longer than `longest_side`: every pixel is the mean
/// (in linear light) of its area. A picture that is small enough comes back as it is.
Pixels shrink(Pixels picture, std::uint32_t longest_side);

/// The picture and smaller ones of it, each half as wide and high as the one before (rounded down,
/// but at least 1), to a single pixel: what a texture is for the distance. Empty where the picture
/// is.
std::vector<Pixels> mip_levels(Pixels picture);

/// The largest middle part of the picture that has the shape of `width` by `height`, shrunk to that
/// size. Nothing is made larger: a part with fewer pixels keeps them.
Pixels fill(const Pixels& picture, std::uint32_t width, std::uint32_t height);

/// The bytes of a PNG file: 8-bit RGBA, or RGB where every pixel is opaque. The same pixels always
/// give the same bytes.
Result<std::vector<std::byte>> encode_png(const Pixels& picture);

/// Is every pixel fully opaque?
bool is_opaque(const Pixels& picture);

/// The bytes of a JPEG file of such quality (92 of 100, colours at full resolution) that nobody
/// sees a difference on a kiosk: a fifth of what the same drawing takes as a PNG. Opacity is lost.
/// The same pixels always give the same bytes.
Result<std::vector<std::byte>> encode_jpeg(const Pixels& picture);

/// Writes a PNG file whole or not at all: a temporary file beside it, then a rename.
Result<void> write_png(const std::filesystem::path& file, const Pixels& picture);

}  // namespace docent::image
