#include "content/character/character.h"

#include <fmt/format.h>

#include <algorithm>

#include "content/character/find_bones.h"
#include "content/content_error.h"
#include "content/import/gltf/read_model.h"

namespace docent::character {
namespace {

void note_losses(const import::gltf::Model& model, Character& character) {
  const bool has_pictures =
      std::ranges::any_of(model.images, [](const Pixels& p) { return !p.rgba.empty(); });
  if (has_pictures)
    character.notes.emplace_back(
        "its pictures are kept as one colour for each vertex: what is finer than a few millimetres "
        "is lost");
  if (character.springs > 0)
    character.notes.push_back(
        character.swinging.bone.empty()
            ? fmt::format("nothing that can be seen hangs on its {} spring chains: nothing swings",
                          character.springs)
            : fmt::format("its {} spring chains swing, by {} bones", character.springs,
                          character.swinging.bone.size()));
  if (!character.expressions.empty())
    character.notes.push_back(
        fmt::format("its {} expressions were read; the face stays as it was modelled",
                    character.expressions.size()));
}

}  // namespace

std::string_view name_of(RestPose pose) {
  return pose == RestPose::T ? "T" : pose == RestPose::A ? "A" : "arms down";
}

Character make_character(const import::gltf::Model& model, const std::string& file) {
  Character character{.file = file,
                      .standing = {},
                      .body = {},
                      .bone_node = std::vector<std::string>(bone_count),
                      .extent = {},
                      .springs = model.vrm.spring_count,
                      .swinging = {},
                      .expressions = model.vrm.expressions,
                      .notes = model.warnings};
  character.standing = stand_up(model, file, character.notes);
  for (std::size_t b = 0; b < bone_count; ++b)
    if (const std::int32_t node = character.standing.bones.node[b]; node >= 0) {
      const std::string& name = model.nodes[static_cast<std::size_t>(node)].name;
      character.bone_node[b] = name.empty() ? fmt::format("#{}", node) : name;
    }
  const std::vector<bool> is_joint = skin_joints(model);
  character.joints = static_cast<std::size_t>(std::ranges::count(is_joint, true));
  character.extent = extent_of(model, character.standing);
  const Colours colours(model);
  character.swinging = springs_of(model, character.standing, character.notes);
  character.body =
      to_budget(surface_of(model, character.standing, character.swinging, file, character.notes),
                character.swinging, colours);
  if (character.body.surface.indices.empty())
    throw content::ContentError(file, 0, 0, "not-humanoid",
                                "it has bones and nothing to see: no triangles in its scene",
                                "export the character with its meshes");
  note_losses(model, character);
  return character;
}

Character read_character(const std::filesystem::path& file) {
  return make_character(import::gltf::read_model(file), file.string());
}

}  // namespace docent::character
