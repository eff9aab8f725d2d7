#include "content/import/gltf/draco.h"

#include <draco/compression/decode.h>

#include <cmath>
#include <memory>
#include <optional>

namespace docent::import::gltf {
namespace {

/// The number of triangles that a Draco file claims (bitstream 2.2, "Draco header" and "Mesh
/// connectivity"): the decoder takes memory on its word, so it is looked at first.
std::optional<std::uint64_t> claimed_triangles(std::string_view bytes) {
  constexpr std::size_t header = 11;
  if (bytes.size() < header + 2 || !bytes.starts_with("DRACO")) return {};
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
  const bool is_mesh = byte(7) == 1, is_edgebreaker = byte(8) == 1;
  const bool has_metadata = (byte(10) & 0x80U) != 0;
  const bool is_known = byte(5) == 2 && byte(6) == 2;
  if (!is_mesh || has_metadata || !is_known) return {};
  std::size_t at = header + (is_edgebreaker ? 1 : 0);
  const auto varint = [&]() -> std::optional<std::uint64_t> {
    std::uint64_t value = 0;
    for (unsigned shift = 0; at < bytes.size() && shift < 35; shift += 7) {
      const std::uint8_t b = byte(at++);
      value |= std::uint64_t{b & 0x7FU} << shift;
      if ((b & 0x80U) == 0) return value;
    }
    return {};
  };
  if (is_edgebreaker && !varint()) return {};  // vertices come first there
  return varint();
}

DracoMesh::Attribute unpacked(const draco::Mesh& mesh, std::uint64_t id, const Part& part) {
  const draco::PointAttribute* attribute =
      mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
  if (attribute == nullptr) part.fail(fmt::format("has no attribute {}", id));
  DracoMesh::Attribute out{.id = id,
                           .components = static_cast<std::size_t>(attribute->num_components()),
                           .value = {},
                           .is_normalised = attribute->normalized()};
  if (out.components == 0 || out.components > 4) part.fail("has an attribute of a strange size");
  std::array<float, 4> element{};
  for (std::uint32_t p = 0; p < mesh.num_points(); ++p) {
    if (!attribute->ConvertValue<float>(attribute->mapped_index(draco::PointIndex(p)),
                                        static_cast<std::int8_t>(out.components), element.data()))
      part.fail(fmt::format("has an attribute {} that cannot be read", id));
    for (std::size_t c = 0; c < out.components; ++c) {
      if (!std::isfinite(element[c])) part.fail("holds a number that is not finite");
      out.value.push_back(element[c]);
    }
  }
  return out;
}

}  // namespace

DracoMesh unpack_draco(std::string_view bytes, const std::vector<std::uint64_t>& ids,
                       std::size_t corners, const Part& part) {
  constexpr std::uint64_t most_triangles_a_byte = 64;
  const std::optional<std::uint64_t> claimed = claimed_triangles(bytes);
  if (!claimed) part.fail("is not compressed by Draco as glTF has it");
  if (*claimed * 3 != corners || *claimed > most_triangles_a_byte * bytes.size())
    part.fail(fmt::format("claims {} triangles, where {} are named and {} bytes are there",
                          *claimed, corners / 3, bytes.size()));
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) part.fail("cannot be unpacked: its Draco data is damaged");
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();

  DracoMesh out;
  out.vertices = mesh->num_points();
  if (out.vertices > most_vertices) part.fail("has too many vertices");
  for (std::uint32_t f = 0; f < mesh->num_faces(); ++f)
    for (const draco::PointIndex& corner : mesh->face(draco::FaceIndex(f)))
      out.corners.push_back(corner.value());
  for (const std::uint64_t id : ids) out.attributes.push_back(unpacked(*mesh, id, part));
  return out;
}

}  // namespace docent::import::gltf
