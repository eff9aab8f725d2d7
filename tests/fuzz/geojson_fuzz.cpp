#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "content/content_error.h"
#include "content/floor/mend.h"
#include "content/import/floor/geojson.h"

using namespace docent;

/// The first byte chooses the coordinates, the rest is a file. Whatever it says, the reader and the
/// mender either refuse it with a sentence or make a plan that keeps FloorPlan's invariants.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const import::Coordinates coordinates =
      data[0] == 'w' ? import::Coordinates::Wgs84 : import::Coordinates::Metres;
  const import::GeoJsonText source{"fuzz.geojson",
                                   {reinterpret_cast<const char*>(data) + 1, size - 1}};
  try {
    std::vector<Diagnostic> mendings;
    const FloorPlan plan =
        floor::mend(import::parse_floor_plan({&source, 1}, coordinates), mendings);
    if (plan.vertex.empty() || plan.next.size() != plan.vertex.size()) __builtin_trap();
    for (std::uint32_t i = 0; i < plan.next.size(); ++i)
      if (plan.next[i] >= plan.vertex.size() || plan.vertex[i] == wall_end(plan, i))
        __builtin_trap();
  } catch (const content::ContentError& error) {
    if (std::string_view(error.what()).empty() || error.code.empty()) __builtin_trap();
  }
  return 0;
}
