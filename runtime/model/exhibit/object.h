#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "runtime/model/geometry/vec2.h"

namespace docent {

/// A vertex of an exhibit's own shape, as texture memory takes it: 16 bytes.
///
/// Frame of an object: it stands on y = 0 with its middle over the origin, y up, its front towards
/// +z. Shares are of its box (ExhibitObject::size), from its lowest corner.
struct ObjectVertex {
  std::array<std::uint16_t, 3> position{};            ///< Of 65535.
  std::array<std::int8_t, 2> normal{};                ///< Octahedral (Cigolle et al. 2014), of 127.
  std::array<std::uint16_t, 2> uv{};                  ///< Of 65535, of the detail's range of `uv`.
  std::array<std::uint8_t, 3> colour{255, 255, 255};  ///< sRGB; a picture is multiplied by it.
  std::uint8_t occlusion = 255;  ///< Share of open space about it, of 255; 0: wholly enclosed.
};

struct ObjectMesh {
  std::vector<ObjectVertex> vertices;
  std::vector<std::uint16_t> triangles;  ///< Counter-clockwise seen from outside, where it has one.
};

enum class ObjectWrap : std::uint8_t { Repeat, Clamp, Mirror };

/// Triangles with one picture, drawn together.
struct ObjectPart {
  std::uint32_t first_index = 0, index_count = 0;
  std::int32_t picture = -1;  ///< -1: the vertices' colours alone.
  std::array<ObjectWrap, 2> wrap{};
};

/// An object as one sees it from nearby. Its parts cover its triangles one after another.
struct ObjectDetail {
  static constexpr std::size_t most_triangles = 30'000, most_parts = 16;

  ObjectMesh mesh;
  std::vector<ObjectPart> parts;
  std::vector<std::vector<std::byte>> pictures;  ///< PNG or JPEG files; what is clear is a hole.
  glm::vec2 uv_low{0}, uv_size{1};               ///< From the upper left, as pictures lie.
};

/// An exhibit's own shape.
struct ExhibitObject {
  static constexpr std::size_t most_distant_triangles = 800;
  static constexpr std::size_t most_bytes = 1'000'000;

  std::string name;    ///< Its file, as staff call it.
  Vec3 size{1};        ///< Metres: wide, high, deep. Not negative; 0 where it is flat.
  ObjectMesh distant;  ///< Of vertices that have their colour, and no picture.
  /// The ObjectDetail, as schema/object_blob.h reads it: at most `most_bytes`.
  std::vector<std::byte> detail;
};

/// Where an exhibit's object stands. Floor frame; its front looks where the exhibit does.
struct ObjectStand {
  Vec2 position{};
  double base = 0;   ///< Metres above the floor.
  double scale = 1;  ///< Of the object's own size: less than 1 where its case is too small for it.
};

}  // namespace docent
