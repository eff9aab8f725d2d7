#pragma once

#include <string_view>

#include "runtime/model/museum.h"

namespace docent {

/// Is an image of the museum a video? The compiler keeps those, and nothing else, under names that
/// end so; their bytes are a WebM file's.
[[nodiscard]] inline bool is_video(const EncodedImage& image) noexcept {
  return image.name.ends_with(".webm");
}

}  // namespace docent
