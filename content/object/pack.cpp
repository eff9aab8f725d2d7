#include "content/object/pack.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "content/content_error.h"
#include "content/import/gltf/colour.h"
#include "platform/image/image.h"
#include "runtime/schema/object_blob.h"

namespace docent::object {
namespace {

using import::gltf::entry;
using import::gltf::Model;

std::uint16_t share(float at, float low, float size) {
  constexpr float most = 65535;
  return static_cast<std::uint16_t>(
      size > 0 ? std::lround(std::clamp((at - low) / size, 0.0F, 1.0F) * most) : 0);
}

std::array<std::uint8_t, 3> bytes_of(const Vec4& linear) {
  const auto byte = [](float part) {
    return static_cast<std::uint8_t>(std::lround(255 * import::gltf::srgb_of(part)));
  };
  return {byte(linear.x), byte(linear.y), byte(linear.z)};
}

ObjectVertex packed(const LitShape& lit, std::size_t v, const Box& box) {
  ObjectVertex vertex{.normal = octahedral(lit.normals[v]), .occlusion = lit.occlusion[v]};
  const Vec3 p = lit.shape.vertices[v].position, size = box.size();
  for (int axis = 0; axis < 3; ++axis)
    vertex.position[static_cast<std::size_t>(axis)] = share(p[axis], box.low[axis], size[axis]);
  return vertex;
}

/// Material colour without its picture.
Vec4 plain_colour(const Model& model, const ShapeVertex& v) {
  if (v.material < 0) return v.tint;
  const import::gltf::Material& material = model.materials[entry(v.material)];
  Vec4 colour = material.base * v.tint;
  for (int i = 0; i < 3; ++i) colour[i] = std::min(colour[i] + material.emissive[i], 1.0F);
  return colour;
}

ObjectWrap wrap_of(import::gltf::Wrap wrap) {
  return wrap == import::gltf::Wrap::Clamp    ? ObjectWrap::Clamp
         : wrap == import::gltf::Wrap::Mirror ? ObjectWrap::Mirror
                                              : ObjectWrap::Repeat;
}

/// What a material's triangles are drawn with: those that share it are one part.
struct PartKey {
  std::int32_t image = -1;
  std::array<ObjectWrap, 2> wrap{};
  auto operator<=>(const PartKey&) const = default;
};

PartKey key_of(const Model& model, std::int32_t material) {
  if (!import::gltf::has_picture(model, material)) return {};
  const import::gltf::Material& it = model.materials[entry(material)];
  return {it.image, {wrap_of(it.wrap[0]), wrap_of(it.wrap[1])}};
}

/// The parts with most triangles keep their picture; what is left over has its colours by vertex.
std::set<PartKey> pictured_parts(const Model& model, const Shape& shape) {
  std::map<PartKey, std::size_t> corners;
  for (const std::uint32_t i : shape.indices) ++corners[key_of(model, shape.vertices[i].material)];
  corners.erase(PartKey{});
  std::vector<std::pair<std::size_t, PartKey>> largest;
  for (const auto& [key, count] : corners) largest.emplace_back(count, key);
  std::ranges::sort(largest, std::greater{});
  largest.resize(std::min(largest.size(), ObjectDetail::most_parts - 1));
  std::set<PartKey> parts;
  for (const auto& [count, key] : largest) parts.insert(key);
  return parts;
}

bool is_mask(const Model& model, std::int32_t image) {
  return std::ranges::any_of(model.materials, [&](const import::gltf::Material& material) {
    return material.image == image && material.alpha == import::gltf::AlphaMode::Mask;
  });
}

std::vector<std::byte> encoded(const Pixels& picture, bool keeps_holes, const std::string& file) {
  auto bytes = keeps_holes && !image::is_opaque(picture) ? image::encode_png(picture)
                                                         : image::encode_jpeg(picture);
  if (!bytes)
    throw content::ContentError(file, 0, 0, "unreadable-model", bytes.error().what,
                                "export the object again with PNG or JPEG pictures");
  return std::move(*bytes);
}

/// The pictures, all with the longest side for which they fit into the room.
std::vector<std::vector<std::byte>> pictures_in(const Model& model,
                                                const std::vector<std::int32_t>& images,
                                                std::size_t room, const std::string& file) {
  std::vector<std::vector<std::byte>> pictures;
  for (const std::uint32_t side : {1024U, 768U, 512U, 384U, 256U, 192U, 128U, 64U, 32U, 8U}) {
    pictures.clear();
    std::size_t bytes = 0;
    for (const std::int32_t image : images) {
      pictures.push_back(
          encoded(image::shrink(model.images[entry(image)], side), is_mask(model, image), file));
      bytes += pictures.back().size();
    }
    if (bytes <= room) return pictures;
  }
  throw content::ContentError(file, 0, 0, "unreadable-model",
                              "it has more pictures than its share of the database has room for",
                              "export the object with fewer pictures");
}

}  // namespace

std::array<std::int8_t, 2> octahedral(Vec3 unit) {
  const float sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
  float x = unit.x / sum, y = unit.y / sum;
  if (unit.z < 0) {
    const float folded = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
    y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
    x = folded;
  }
  const auto byte = [](float part) {
    return static_cast<std::int8_t>(std::lround(127 * std::clamp(part, -1.0F, 1.0F)));
  };
  return {byte(x), byte(y)};
}

ObjectMesh pack_distant(const LitShape& lit, const Model& model, const Box& box) {
  ObjectMesh mesh;
  for (std::size_t v = 0; v < lit.shape.vertices.size(); ++v) {
    const ShapeVertex& it = lit.shape.vertices[v];
    mesh.vertices.push_back(packed(lit, v, box));
    mesh.vertices.back().colour =
        bytes_of(import::gltf::colour_at(model, it.material, it.uv, it.tint));
  }
  for (const std::uint32_t i : lit.shape.indices)
    mesh.triangles.push_back(static_cast<std::uint16_t>(i));
  return mesh;
}

ObjectDetail pack_detail(const LitShape& lit, const Model& model, const Box& box,
                         const std::string& file) {
  const Shape& shape = lit.shape;
  ObjectDetail detail;
  glm::vec2 low{0}, high{0};
  for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
    low = v == 0 ? shape.vertices[v].uv : glm::min(low, shape.vertices[v].uv);
    high = v == 0 ? shape.vertices[v].uv : glm::max(high, shape.vertices[v].uv);
  }
  const std::set<PartKey> pictured = pictured_parts(model, shape);
  const auto part_of = [&](std::int32_t material) {
    const PartKey key = key_of(model, material);
    return pictured.contains(key) ? key : PartKey{};
  };
  detail.uv_low = low;
  detail.uv_size = high - low;
  for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
    ObjectVertex& vertex = detail.mesh.vertices.emplace_back(packed(lit, v, box));
    const ShapeVertex& it = shape.vertices[v];
    vertex.colour = bytes_of(part_of(it.material).image >= 0
                                 ? plain_colour(model, it)
                                 : import::gltf::colour_at(model, it.material, it.uv, it.tint));
    vertex.uv = {share(it.uv.x, low.x, detail.uv_size.x), share(it.uv.y, low.y, detail.uv_size.y)};
  }
  std::map<PartKey, std::vector<std::uint32_t>> parts;
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    auto& part = parts[part_of(shape.vertices[shape.indices[k]].material)];
    part.insert(part.end(), &shape.indices[k], &shape.indices[k] + 3);
  }
  std::vector<std::int32_t> images;
  for (auto& [key, indices] : parts) {
    meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(),
                                shape.vertices.size());
    ObjectPart part{.first_index = static_cast<std::uint32_t>(detail.mesh.triangles.size()),
                    .index_count = static_cast<std::uint32_t>(indices.size()),
                    .wrap = key.wrap};
    for (const std::uint32_t i : indices)
      detail.mesh.triangles.push_back(static_cast<std::uint16_t>(i));
    if (key.image >= 0) {
      const auto known = std::ranges::find(images, key.image);
      part.picture = static_cast<std::int32_t>(known - images.begin());
      if (known == images.end()) images.push_back(key.image);
    }
    detail.parts.push_back(part);
  }
  const std::size_t shape_bytes = schema::encode(detail).size() + 4 * images.size();
  if (!images.empty())
    detail.pictures = pictures_in(
        model, images, ExhibitObject::most_bytes - std::min(shape_bytes, ExhibitObject::most_bytes),
        file);
  return detail;
}

}  // namespace docent::object
