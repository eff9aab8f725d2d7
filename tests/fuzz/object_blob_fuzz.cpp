#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/schema/object_blob.h"

/// Any bytes are no object's detail, or one that keeps its promises and comes back as it is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace docent;
  ObjectDetail detail, back;
  if (!schema::decode(std::as_bytes(std::span(data, size)), detail)) return 0;
  if (!schema::is_whole(detail.mesh)) __builtin_trap();
  for (const ObjectPart& part : detail.parts)
    if (part.first_index + part.index_count > detail.mesh.triangles.size() ||
        part.picture >= static_cast<std::int32_t>(detail.pictures.size()))
      __builtin_trap();
  if (!schema::decode(schema::encode(detail), back)) __builtin_trap();
  return 0;
}
