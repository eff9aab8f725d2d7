#include "content/compile/compile_scenery.h"

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

#include "content/scenery/scenery.h"
#include "content/scenery/tints.h"

namespace docent::compile {

namespace {

std::vector<float> image_aspects(const Museum& museum) {
  std::vector<float> aspects;
  for (const Exhibit& exhibit : museum.exhibits) {
    const EncodedImage& image = museum.images[exhibit.image];
    aspects.push_back(image.height == 0
                          ? 1.0F
                          : static_cast<float>(image.width) / static_cast<float>(image.height));
  }
  return aspects;
}

std::vector<scenery::PavedArea> paving_of(const config::MuseumConfig* config, const Museum& museum,
                                          std::size_t floor) {
  using scenery::Paving;
  std::vector<scenery::PavedArea> areas;
  if (config == nullptr) return areas;
  for (std::size_t i = 0; i < config->rooms.size(); ++i) {
    const Room& room = museum.rooms[i];
    if (room.floor == floor && !room.outline.empty())
      areas.push_back(
          {.outline = room.outline,
           .paving = config->rooms[i].paving.value == "stone" ? Paving::Stone : Paving::Oak});
  }
  scenery::tint_apart(areas);
  // Where areas overlap in a doorway the first has it: stone.
  std::ranges::stable_partition(areas, [](const auto& a) { return a.paving == Paving::Stone; });
  return areas;
}

/// Where a floor meets the connections: the flights up and down from it, and lifts.
std::vector<scenery::Passage> passages_of(const Museum& museum, std::size_t floor) {
  std::vector<scenery::Passage> passages;
  for (const Connection& connection : museum.connections)
    for (std::size_t i = 0; i < connection.stops.size(); ++i) {
      const ConnectionStop& here = connection.stops[i];
      if (here.floor != floor) continue;
      if (connection.kind == ConnectionKind::Lift) {
        passages.push_back({.kind = connection.kind, .here = here.placement});
        continue;
      }
      const auto add = [&](const ConnectionStop& there) {
        passages.push_back(
            {.kind = connection.kind,
             .here = here.placement,
             .there = there.placement.position,
             .rise = museum.floors[there.floor].plan.height - museum.floors[floor].plan.height});
      };
      if (i + 1 < connection.stops.size()) add(connection.stops[i + 1]);
      if (i > 0) add(connection.stops[i - 1]);
    }
  return passages;
}

/// What exhibits take of the floor: across and deep, one per exhibit.
std::vector<Vec2> taken(std::span<const DrawnFloor> drawn, std::size_t exhibits) {
  std::vector<Vec2> sizes(exhibits);
  for (const DrawnFloor& floor : drawn)
    for (const Standing& thing : floor.standing)
      if (thing.kind == Standing::Kind::Exhibit && takes_floor(thing))
        sizes[thing.index] = thing.footprint.size;
  return sizes;
}

}  // namespace

DrawnFloor drawn_floor(const CompiledFloor& compiled) {
  DrawnFloor drawn{compiled.with_cases, compiled.standing};
  drawn.plan.height = compiled.floor.plan.height;
  return drawn;
}

void compile_scenery(const config::MuseumConfig* config, std::span<const DrawnFloor> drawn,
                     Museum& museum, std::optional<double> texel) {
  const std::vector<float> aspects = image_aspects(museum);
  std::vector<Vec3> objects(museum.exhibits.size(), Vec3{0});
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (const std::int32_t object = museum.exhibits[i].object; object >= 0)
      objects[i] = museum.objects[static_cast<std::size_t>(object)].size;
  std::vector<ObjectStand> stands(museum.exhibits.size());
  for (std::size_t i = 0; i < museum.floors.size(); ++i) {
    scenery::SceneryOptions options;
    options.floor = static_cast<std::uint32_t>(i);
    if (texel) options.texel = *texel;
    options.passages = passages_of(museum, i);
    options.objects = objects;
    options.taken = taken(drawn, museum.exhibits.size());
    // The overview is turned as the visitor stands at the kiosk.
    for (const KioskPlace& kiosk : museum.kiosks | std::views::reverse)
      if (kiosk.floor == i) options.up = kiosk.placement.heading;
    if (museum.kiosk_floor == i) options.up = museum.kiosk.heading;
    museum.scenery.push_back(scenery::make_scenery(drawn[i].plan, museum.exhibits, aspects,
                                                   paving_of(config, museum, i), options, stands));
  }
  for (std::size_t i = 0; i < stands.size(); ++i) museum.exhibits[i].stand = stands[i];
}

}  // namespace docent::compile
