#pragma once

#include <filesystem>
#include <string>

#include "runtime/model/museum.h"

namespace docent {

/// Reads a picture. PNG and JPEG files are checked and kept as they are; SVG drawings become PNG
/// with a longest side of 1024 pixels. `name` is what the museum calls it.
/// Throws ContentError (`unreadable-image`) where the file is none of these or is damaged, and
/// (`image-too-large`) where it is wider or higher than 4096 pixels.
EncodedImage load_image(const std::filesystem::path& file, const std::string& name);

/// A plain card for exhibits without a picture.
EncodedImage blank_image();

}  // namespace docent
