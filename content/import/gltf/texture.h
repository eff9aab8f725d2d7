#pragma once

#include <string_view>

#include "runtime/model/pixels.h"
#include "runtime/model/result.h"

namespace docent::import::gltf {

/// A picture that lies on a model: PNG, JPEG or WebP, with a longest side of 1024 pixels. A
/// sentence without its subject where it cannot be read; any bytes are safe.
Result<Pixels> decode_texture(std::string_view bytes);

}  // namespace docent::import::gltf
