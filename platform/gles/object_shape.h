#pragma once

#include <array>
#include <span>
#include <vector>

#include "platform/gles/gl_names.h"
#include "platform/image/image.h"
#include "runtime/model/exhibit/object.h"

namespace docent::gles {

/// An object in one level of detail, in texture memory.
struct ObjectShape {
  GlBuffer vertices, indices;
  GlVertexArray array;
  std::array<ObjectPart, ObjectDetail::most_parts> parts{};
  std::size_t part_count = 0;
  std::array<GlTexture, ObjectDetail::most_parts> pictures;
  std::array<float, 4> uv_range{0, 0, 1, 1};
};

/// Of a mesh without pictures.
ObjectShape make_object_shape(const ObjectMesh& mesh) noexcept;
/// Of a detail, whose pictures follow one by one. Does not allocate.
ObjectShape make_object_shape(const ObjectDetail& detail) noexcept;
void add_picture(ObjectShape& shape, std::size_t picture, std::span<const Pixels> levels) noexcept;

/// The exhibits' objects: all of them from afar, one of them from nearby.
struct Objects {
  struct Entry {
    Vec3 size{1};
    ObjectShape distant;
  };
  std::vector<Entry> entries;
  std::uint32_t near = 0;  ///< Whose detail that is.
  ObjectShape detail;      ///< Without an array where there is none.
  ObjectShape coming;      ///< Not whole yet.

  /// How it is drawn; null where it is not there.
  const ObjectShape* shape_of(std::uint32_t object, bool from_nearby) const noexcept;
};

}  // namespace docent::gles
