#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "content/import/gltf/model.h"
#include "content/import/gltf/read_model.h"

/// Shapes of things that museums show, read exactly.
namespace docent::import::object {

enum class UpAxis : std::uint8_t { Y, Z };

/// A shape as its file has it, and what the file's kind says of its frame.
struct ObjectFile {
  gltf::Model model;
  bool is_in_metres = false;  ///< By the rules of its kind: glTF. The others carry no unit.
  bool says_up = false;       ///< Likewise: glTF is y up.
  UpAxis up = UpAxis::Y;      ///< What is usual in files of that kind, where they do not say it.
};

/// Reads glTF 2.0, GLB, VRM, Wavefront OBJ with its MTL, PLY (text or binary) or STL (likewise),
/// known by what the bytes are and not by the file's name.
///
/// Any bytes are safe: no count is believed, memory stays in proportion to the file's size, and
/// what cannot be used is a ContentError (`unreadable-model`) that names the part that is wrong, by
/// its line where it has one. Faces that name no corner, and pictures that are not there, are left
/// out and told in `model.warnings`.
ObjectFile parse_object(std::string_view bytes, const std::string& file,
                        const gltf::ReadBeside& beside);

/// Likewise, from the disk. Only files in the model's own folder and below are opened.
ObjectFile read_object(const std::filesystem::path& file);

}  // namespace docent::import::object
