#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "content/character/budget.h"
#include "content/character/springs.h"
#include "content/character/standing.h"

namespace docent::character {

/// A museum's own character, read and checked: what can become a guide.
struct Character {
  std::string file;
  Standing standing;                   ///< In the file's own size.
  ColouredSurface body;                ///< In the frame of Standing, in the file's own size.
  std::vector<std::string> bone_node;  ///< By HumanBone: the node's name; "#7" for one without.
  Extent extent;                       ///< Of all that the file shows.
  std::size_t joints = 0;              ///< Of its skins, each once.
  std::size_t springs = 0;             ///< Chains that the file says swing...
  Springs swinging;                    ///< ... and what of them does.
  std::vector<std::string> expressions;
  std::vector<std::string> notes;  ///< What was mended, left out or lost: sentences.
};

/// Reads a VRM, GLB or glTF file. ContentError (`unreadable-model`, `not-humanoid`) that names
/// what is wrong with it.
Character read_character(const std::filesystem::path& file);

/// Makes a character of a model that was read already.
Character make_character(const import::gltf::Model& model, const std::string& file);

/// "T", "A" or "arms down".
std::string_view name_of(RestPose pose);

}  // namespace docent::character
