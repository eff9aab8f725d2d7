#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "content/import/gltf/model.h"

namespace docent::import::gltf {

/// Reads a file that lies beside the model: its name as the model has it, checked not to leave the
/// folder. Empty where there is none.
using ReadBeside = std::function<std::optional<std::string>(const std::string& name)>;

/// Does such a name stay in the folder that it is looked up in?
bool stays_below(std::string_view name);

/// Reads files that lie beside a model on the disk.
ReadBeside beside_on_disk(const std::filesystem::path& model);

/// Reads glTF 2.0 (text or GLB) and VRM: what the scene shows, its skins, base colours, and what
/// VRM says. Meshes may be compressed (KHR_draco_mesh_compression, EXT_meshopt_compression) or
/// quantised.
///
/// Any bytes are safe: nothing is taken on a file's word, memory stays in proportion to its size,
/// and what cannot be used is a ContentError (`unreadable-model`) that names the file's part:
/// "accessors[3].count". What can be done without (a picture, lines, an unknown joint) is left out
/// and told in `warnings`.
Model parse_model(std::string_view bytes, const std::string& file, const ReadBeside& beside);

/// Likewise, from the disk. Only files in the model's own folder and below are opened.
Model read_model(const std::filesystem::path& file);

}  // namespace docent::import::gltf
