#include "content/import/gltf/read_model.h"

#include <algorithm>
#include <array>
#include <string>

#include "content/import/gltf/mesh.h"
#include "content/import/gltf/scene.h"
#include "content/import/gltf/source.h"
#include "content/read_source.h"
#include "platform/file/read_file.h"

namespace docent::import::gltf {
namespace {

/// What a file may require of its reader; materials' extensions beyond these only look less fine.
constexpr std::array known_extensions{"KHR_draco_mesh_compression",
                                      "EXT_meshopt_compression",
                                      "KHR_mesh_quantization",
                                      "KHR_texture_transform",
                                      "KHR_lights_punctual",
                                      "EXT_texture_webp",
                                      "EXT_texture_avif",
                                      "VRM",
                                      "VRMC_vrm",
                                      "VRMC_springBone",
                                      "VRMC_node_constraint",
                                      "VRMC_springBone_extended_collider"};

void check_extensions(const Source& source) {
  const Part required = source.root()["extensionsRequired"];
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string name = required.at(i).text();
    if (std::ranges::find(known_extensions, name) == known_extensions.end() &&
        !name.starts_with("KHR_materials_") && !name.starts_with("VRMC_materials_")) {
      if (name == "KHR_texture_basisu")
        required.at(i).fail(
            "is KHR_texture_basisu: its pictures are KTX2, which cannot be read here; export them "
            "as PNG, JPEG or WebP");
      required.at(i).fail(fmt::format("is {}, which cannot be read here", plain_name(name)));
    }
  }
}

/// Reads the meshes that the scene shows: each for the first skin it hangs on.
void read_meshes(Source& source, Model& model) {
  model.meshes.resize(source.root()["meshes"].size());
  std::vector<std::int32_t> skin_of(model.meshes.size(), -2);
  for (const std::int32_t n : model.order) {
    Node& node = model.nodes[static_cast<std::size_t>(n)];
    if (!node.in_scene || node.mesh < 0) continue;
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (skin_of[mesh] == -2) {
      const std::size_t joints =
          node.skin < 0 ? 0 : model.skins[static_cast<std::size_t>(node.skin)].joints.size();
      model.meshes[mesh] = read_mesh(source, mesh, joints, model.materials);
      skin_of[mesh] = node.skin;
      continue;
    }
    // Shown once more: its vertices count again, and another skin must have its joints.
    for (const Primitive& primitive : model.meshes[mesh].primitives) {
      const Part part = source.root()["nodes"].at(static_cast<std::size_t>(n));
      source.count_vertices(primitive.position.size(), part);
      source.count_corners(primitive.indices.size(), part);
    }
    const auto joints_in = [&](std::int32_t skin) {
      return skin < 0 ? 0 : model.skins[static_cast<std::size_t>(skin)].joints.size();
    };
    if (joints_in(node.skin) < joints_in(skin_of[mesh])) node.skin = skin_of[mesh];
  }
}

void read_images(Source& source, Model& model) {
  constexpr std::size_t most_pixels = 32'000'000;
  model.images.resize(source.root()["images"].size());
  std::size_t pixels = 0;
  std::vector<bool> is_read(model.images.size());
  for (const Mesh& mesh : model.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      if (primitive.material < 0) continue;
      const std::int32_t image =
          model.materials[static_cast<std::size_t>(primitive.material)].image;
      if (image < 0) continue;
      const auto index = static_cast<std::size_t>(image);
      if (is_read[index]) continue;
      is_read[index] = true;
      if (pixels > most_pixels) {
        source.warn("its pictures have too many pixels in all; the last are left out");
        continue;
      }
      model.images[index] = read_image(source, index);
      pixels += std::size_t{model.images[index].width} * model.images[index].height;
    }
}

}  // namespace

Model parse_model(std::string_view bytes, const std::string& file, const ReadBeside& beside) {
  Source source(bytes, file, beside);
  check_extensions(source);
  Model model;
  read_scene(source, model);
  model.materials = read_materials(source);
  read_meshes(source, model);
  read_images(source, model);
  model.vrm = read_vrm(source, model.nodes.size());
  look_over(source);
  model.warnings = std::move(source.warnings);
  return model;
}

ReadBeside beside_on_disk(const std::filesystem::path& model) {
  return [folder = model.parent_path()](const std::string& name) -> std::optional<std::string> {
    Result<std::string> read = file::read_file(folder / name);
    return read ? std::optional(std::move(*read)) : std::nullopt;
  };
}

Model read_model(const std::filesystem::path& file) {
  return parse_model(content::read_source(file), file.string(), beside_on_disk(file));
}

}  // namespace docent::import::gltf
