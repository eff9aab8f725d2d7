#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/character/character.h"
#include "content/character/fit.h"
#include "content/content_error.h"
#include "content/import/gltf/read_model.h"

/// Any bytes are a character within its budget, with finite places, or a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace docent;
  try {
    const import::gltf::Model model =
        import::gltf::parse_model({reinterpret_cast<const char*>(data), size}, "fuzz.glb", {});
    const character::Character it = character::make_character(model, "fuzz.glb");
    const character::Surface& surface = it.body.surface;
    if (surface.indices.size() > 3 * character::most_triangles) __builtin_trap();
    if (it.body.colour.size() != surface.vertices.size()) __builtin_trap();
    for (const std::uint32_t i : surface.indices)
      if (i >= surface.vertices.size()) __builtin_trap();
    const character::Measures measures = character::measure(it);
    for (const character::SurfaceVertex& v : surface.vertices)
      if (!std::isfinite(glm::length(measures.place(v.position)))) __builtin_trap();
  } catch (const content::ContentError& error) {
    if (error.code.empty()) __builtin_trap();
  }
  return 0;
}
