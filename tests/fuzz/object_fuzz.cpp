#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/object/crease.h"
#include "content/object/simplify.h"
#include "content/object/stand_up.h"

/// Any bytes are an object within its budget, with finite places, or a sentence: PLY, STL and glTF
/// by what they begin with, all else as OBJ.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace docent;
  try {
    const import::object::ObjectFile file =
        import::object::parse_object({reinterpret_cast<const char*>(data), size}, "fuzz.obj", {});
    std::vector<std::string> notes;
    object::Shape shape = object::shape_of(file.model, "fuzz.obj", notes);
    object::stand_up(file, {}, shape, notes);
    constexpr std::size_t few = 100;
    object::simplify(shape, few);
    if (shape.indices.empty() || shape.indices.size() > 3 * few) __builtin_trap();
    const std::vector<Vec3> normals = object::crease(shape, 1);
    if (normals.size() != shape.vertices.size()) __builtin_trap();
    for (const std::uint32_t i : shape.indices)
      if (i >= shape.vertices.size()) __builtin_trap();
    for (const object::ShapeVertex& v : shape.vertices)
      if (!std::isfinite(v.position.x + v.position.y + v.position.z)) __builtin_trap();
  } catch (const content::ContentError& error) {
    if (error.code.empty()) __builtin_trap();
  }
  return 0;
}
