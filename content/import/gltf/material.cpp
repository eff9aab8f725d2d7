#include <algorithm>
#include <cmath>
#include <span>

#include "content/import/gltf/scene.h"
#include "content/import/gltf/texture.h"
#include "content/import/picture/read_picture.h"
#include "platform/image/image.h"

namespace docent::import::gltf {
namespace {

Wrap wrap_of(const Part& part) {
  switch (part.whole_or(10497, UINT32_MAX)) {
    case 33071:
      return Wrap::Clamp;
    case 33648:
      return Wrap::Mirror;
    default:
      return Wrap::Repeat;
  }
}

/// What a texture shows: its picture, or that of an extension for pictures of another kind.
std::int32_t image_of(const Part& texture, std::size_t images) {
  if (const Part extensions = texture["extensions"]; extensions.is_there())
    for (const char* name : {"EXT_texture_webp", "EXT_texture_avif"})
      if (const Part other = extensions[name]; other.is_there())
        return other["source"].index_or_none(images, "image");
  return texture["source"].index_or_none(images, "image");
}

void take_texture(Source& source, const Part& use, Material& material) {
  const Part textures = source.root()["textures"];
  const std::int32_t index = use["index"].index_or_none(textures.size(), "texture");
  if (index < 0) use["index"].fail("is missing");
  const Part texture = textures.at(static_cast<std::size_t>(index));
  material.image = image_of(texture, source.root()["images"].size());
  const auto most_sets = 7;
  material.uv_set = static_cast<std::uint32_t>(use["texCoord"].whole_or(0, most_sets));
  const Part samplers = source.root()["samplers"];
  if (const std::int32_t sampler = texture["sampler"].index_or_none(samplers.size(), "sampler");
      sampler >= 0) {
    const Part part = samplers.at(static_cast<std::size_t>(sampler));
    material.wrap = {wrap_of(part["wrapS"]), wrap_of(part["wrapT"])};
  }
  if (const Part extensions = use["extensions"]; extensions.is_there())
    if (const Part transform = extensions["KHR_texture_transform"]; transform.is_there()) {
      const auto pair = [](const Part& part, glm::vec2 otherwise) {
        return part.is_there() ? glm::vec2(part.at(0).number(), part.at(1).number()) : otherwise;
      };
      material.uv_offset = pair(transform["offset"], glm::vec2(0));
      material.uv_scale = pair(transform["scale"], glm::vec2(1));
      material.uv_turn = transform["rotation"].number_or(0);
      material.uv_set =
          static_cast<std::uint32_t>(transform["texCoord"].whole_or(material.uv_set, most_sets));
    }
}

Material material_of(Source& source, const Part& part) {
  Material material{.name = plain_name(part["name"].text_or(""))};
  if (const Part pbr = part["pbrMetallicRoughness"]; pbr.is_there()) {
    material.base = pbr["baseColorFactor"].vec4_or(Vec4{1});
    if (const Part texture = pbr["baseColorTexture"]; texture.is_there())
      take_texture(source, texture, material);
  }
  for (int i = 0; i < 4; ++i) material.base[i] = std::clamp(material.base[i], 0.0F, 1.0F);
  material.emissive = part["emissiveFactor"].vec3_or(Vec3{0});
  const std::string alpha = part["alphaMode"].text_or("OPAQUE");
  material.alpha = alpha == "MASK"    ? AlphaMode::Mask
                   : alpha == "BLEND" ? AlphaMode::Blend
                                      : AlphaMode::Opaque;
  material.alpha_cutoff = part["alphaCutoff"].number_or(0.5F);
  material.double_sided = part["doubleSided"].flag_or(false);
  return material;
}

std::optional<std::string> bytes_of_image(Source& source, const Part& part) {
  if (part["uri"].is_there()) return source.bytes_of_uri(part["uri"]);
  return std::string(source.view(part["bufferView"].whole(0, UINT32_MAX)).bytes);
}

}  // namespace

std::vector<Material> read_materials(Source& source) {
  const Part parts = source.root()["materials"];
  if (parts.size() > most_nodes) parts.fail("has too many entries");
  std::vector<Material> materials;
  for (std::size_t i = 0; i < parts.size(); ++i)
    materials.push_back(material_of(source, parts.at(i)));
  return materials;
}

Result<Pixels> decode_texture(std::string_view bytes) {
  constexpr std::uint32_t side = 8192;
  constexpr std::uint64_t pixels = 16'777'216;
  // No visitor sees more of it than that.
  constexpr std::uint32_t longest_side = 1024;
  const auto span = std::as_bytes(std::span(bytes));
  if (bytes.starts_with("\xABKTX 20"))
    return std::unexpected(
        Error{Errc::InvalidInput,
              "it is a KTX2 picture, which cannot be read here: write it as PNG, "
              "JPEG or WebP"});
  if (bytes.size() > 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WEBP") {
    try {
      return image::shrink(read_webp(span, {.side = side, .pixels = pixels}), longest_side);
    } catch (const content::ContentError& error) {
      return std::unexpected(Error{Errc::InvalidInput, error.what()});
    }
  }
  Result<Pixels> decoded = image::decode_image(span, {.side = side, .pixels = pixels});
  if (decoded) *decoded = image::shrink(std::move(*decoded), longest_side);
  return decoded;
}

Pixels read_image(Source& source, std::size_t index) {
  const Part part = source.root()["images"].at(index);
  const std::optional<std::string> bytes = bytes_of_image(source, part);
  if (!bytes) {
    source.warn(
        fmt::format("{}: there is no file '{}' beside the model; its colour is used "
                    "without the picture",
                    part.name(), plain_name(part["uri"].text())));
    return {};
  }
  Result<Pixels> pixels = decode_texture(*bytes);
  if (pixels) return std::move(*pixels);
  source.warn(fmt::format("{} cannot be shown ({}); its material's colour is used without it",
                          part.name(), pixels.error().what));
  return {};
}

}  // namespace docent::import::gltf
