#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "runtime/model/museum.h"
#include "runtime/model/pixels.h"
#include "runtime/scene/colour.h"

namespace docent::compile {

/// A museum's sign, without the empty margin about it.
struct Logo {
  EncodedImage image;
  Pixels pixels;
  std::optional<scene::Colour>
      ground{};  ///< It lies on a ground of its own, which is of one colour.
};

/// Reads a logo as load_image does; one of more than 768 pixels a side is made smaller. Throws
/// ContentError (`unreadable-image`) where the file is no picture, and where nothing is in it.
Logo load_logo(const std::filesystem::path& file, const std::string& name);

/// Is enough of it, a third, told from what it lies on by 3:1?
bool shows_on(const Logo& logo, const scene::Colour& paper) noexcept;

}  // namespace docent::compile
