#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "config/toml_document.h"
#include "content/content_error.h"
#include "content/import/building/museum_text.h"
#include "content/import/building/read_building.h"

using namespace docent;

namespace {

void expect_finite(const import::ImportedBuilding& building) {
  const auto check = [](Vec2 p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) __builtin_trap();
  };
  for (const import::ImportedLevel& level : building.levels) {
    for (const import::ImportedRoom& room : level.rooms)
      for (const import::BuildingRing& ring : room.rings)
        for (const Vec2 corner : ring) check(corner);
    for (const import::ImportedDoor& door : level.doors) {
      check(door.a);
      check(door.b);
    }
  }
}

/// What is written into a museum is text that the museum's own loader reads.
void expect_readable(import::ImportedBuilding building) {
  import::LaidBuilding laid = import::lay_out(std::move(building));
  const import::MuseumManner manner{.title = "fuzz", .speaks = [](const std::string& language) {
                                      return language == "en" || language == "de";
                                    }};
  for (const import::MuseumText& file : import::museum_texts(laid, manner))
    if (file.name.ends_with(".toml") && !config::parse_toml(file.text, file.name).root)
      __builtin_trap();
}

}  // namespace

/// Any bytes, read by the reader that they call for: a museum's files, or a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const import::BuildingSource source{"fuzz",
                                      std::string(reinterpret_cast<const char*>(data), size), ""};
  try {
    auto building = import::read_building({&source, 1}, {});
    if (!building) {
      if (building.error().empty() || building.error().front().message.empty()) __builtin_trap();
      return 0;
    }
    expect_finite(*building);
    expect_readable(std::move(*building));
  } catch (const content::ContentError& error) {
    if (std::string_view(error.what()).empty() || error.code.empty()) __builtin_trap();
  }
  return 0;
}
