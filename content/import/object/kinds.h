#pragma once

#include <string>
#include <string_view>

#include "content/import/gltf/model.h"
#include "content/import/gltf/read_model.h"

/// A reader a kind of file. Internal to import/object.
namespace docent::import::object {

gltf::Model parse_obj(std::string_view text, const std::string& file,
                      const gltf::ReadBeside& beside);

bool is_ply(std::string_view bytes);
gltf::Model parse_ply(std::string_view bytes, const std::string& file,
                      const gltf::ReadBeside& beside);

bool is_stl(std::string_view bytes);
gltf::Model parse_stl(std::string_view bytes, const std::string& file);

}  // namespace docent::import::object
