#pragma once

#include <string_view>

#include "content/import/gltf/model.h"
#include "content/import/gltf/source.h"

namespace docent::import::gltf {

/// What a mesh compressed with Draco unpacks to.
struct DracoMesh {
  std::vector<std::uint32_t> corners;
  std::size_t vertices = 0;
  struct Attribute {
    std::uint64_t id = 0;
    std::size_t components = 0;
    std::vector<float> value;
    bool is_normalised = false;  ///< Whole numbers became shares already.
  };
  std::vector<Attribute> attributes;
};

/// Unpacks the attributes with these ids. `corners` is what the file claims: a mesh that unpacks
/// to anything else is refused before its memory is taken. ContentError about `part`.
DracoMesh unpack_draco(std::string_view bytes, const std::vector<std::uint64_t>& ids,
                       std::size_t corners, const Part& part);

}  // namespace docent::import::gltf
