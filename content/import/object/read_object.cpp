#include "content/import/object/read_object.h"

#include <algorithm>
#include <cctype>

#include "content/import/object/kinds.h"
#include "content/import/object/object_text.h"
#include "content/read_source.h"

namespace docent::import::object {
namespace {

bool has_ending(const std::string& file, std::string_view ending) {
  const std::string_view name(file);
  return name.size() >= ending.size() &&
         std::ranges::equal(name.substr(name.size() - ending.size()), ending, [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

bool is_gltf(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return bytes.starts_with("glTF") || bytes.starts_with("\xEF\xBB\xBF{") ||
         (first != std::string_view::npos && bytes[first] == '{');
}

void check_shape(const gltf::Model& model, const std::string& file) {
  for (const gltf::Mesh& mesh : model.meshes)
    for (const gltf::Primitive& primitive : mesh.primitives)
      if (!primitive.indices.empty()) return;
  fail(file, 0,
       model.warnings.empty() ? "it holds no triangle: there is nothing to show"
                              : "it holds no triangle that can be used: " + model.warnings.front());
}

}  // namespace

ObjectFile parse_object(std::string_view bytes, const std::string& file,
                        const gltf::ReadBeside& beside) {
  ObjectFile object;
  if (bytes.empty()) fail(file, 0, "this file is empty");
  const bool is_named_gltf =
      has_ending(file, ".glb") || has_ending(file, ".gltf") || has_ending(file, ".vrm");
  if (is_gltf(bytes) || is_named_gltf) {
    object = {gltf::parse_model(bytes, file, beside), true, true, UpAxis::Y};
  } else if (is_ply(bytes)) {
    object.model = parse_ply(bytes, file, beside);
  } else if (is_stl(bytes) || has_ending(file, ".stl")) {
    object.model = parse_stl(bytes, file);
    object.up = UpAxis::Z;
  } else if (has_ending(file, ".obj")) {
    object.model = parse_obj(bytes, file, beside);
  } else {
    fail(file, 0, "this is no object that can be read: neither glTF, GLB, OBJ, PLY nor STL");
  }
  check_shape(object.model, file);
  return object;
}

ObjectFile read_object(const std::filesystem::path& file) {
  return parse_object(
      content::read_source(file, "unreadable-model", "name a file that may be read"), file.string(),
      gltf::beside_on_disk(file));
}

}  // namespace docent::import::object
