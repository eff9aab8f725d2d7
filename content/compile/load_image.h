#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/model/pixels.h"

namespace docent::compile {

/// Reads a picture. PNG and JPEG files are decoded once to see that they are whole, and kept as
/// they are where they are at most 2048 pixels a side; larger ones, and SVG drawings, become JPEG
/// (PNG where they are partly clear) with a longest side of 768 pixels, the most that a card on a
/// kiosk shows. Pictures of the kinds that only staff's machines have (WebP, GIF, HEIC, AVIF)
/// become JPEG or PNG, too; of a GIF that moves it is the first frame. `name` is what the museum
/// calls it. Throws ContentError (`unreadable-image`) where the file is none of these or damaged.
EncodedImage load_image(const std::filesystem::path& file, const std::string& name);

/// The picture of a file that was loaded, as it hangs in the model with a longest side of so many
/// pixels: a JPEG (PNG where it is partly clear). Empty where it is as small as that. `file` is for
/// the sentence of an error.
std::vector<std::byte> small_picture(const std::filesystem::path& file, const EncodedImage& image,
                                     std::uint32_t side);

/// A picture's pixels, made smaller where a side is longer than `longest`; a drawing is drawn so
/// large. Throws as load_image does.
Pixels load_pixels(const std::filesystem::path& file, std::uint32_t longest);

/// Throws as load_image does, and makes nothing: an SVG is drawn as small as a stamp.
void check_image(const std::filesystem::path& file);

/// A plain picture for exhibits that have none.
EncodedImage blank_image();

}  // namespace docent::compile
