#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace docent::import::gltf {

/// A glTF file's two halves.
struct Container {
  nlohmann::json json;      ///< An object.
  std::string_view binary;  ///< The GLB's second chunk; empty in a text file.
  bool has_binary = false;
};

/// Takes a glTF text or a GLB apart. ContentError (`unreadable-model`) where it is cut short, not
/// glTF 2, or no JSON; nothing beyond `bytes` is read, and no length is believed.
Container open_container(std::string_view bytes, const std::string& file);

}  // namespace docent::import::gltf
