#include "content/import/drawing/outlined_rooms.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "content/import/drawing/drawn_box.h"
#include "content/import/drawing/face_rooms.h"
#include "content/import/drawing/inscribed.h"
#include "content/import/drawing/label.h"
#include "content/import/drawing/tidy_rooms.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::import {

std::optional<std::uint32_t> layer_of_outlines(const Drawing& drawing,
                                               const std::vector<LayerKind>& kinds) {
  std::vector<std::size_t> large(drawing.layers.size(), 0), labelled(large), all(large);
  for (const DrawnRing& ring : drawing.rings) {
    ++all[ring.layer];
    const double area = std::abs(signed_area(ring.corners));
    if (area < 1.5 || area > 50'000 || inscribed_circle({{ring.corners}}).radius < narrowest_room)
      continue;
    ++large[ring.layer];
    labelled[ring.layer] += std::ranges::any_of(
        drawing.texts, [&](const DrawnText& text) { return contains(ring.corners, text.at); });
  }
  std::optional<std::uint32_t> best;
  for (std::uint32_t layer = 0; layer < large.size(); ++layer) {
    if (kinds[layer] == LayerKind::Other || kinds[layer] == LayerKind::Door) continue;
    const bool called_so = kinds[layer] == LayerKind::Room && large[layer] >= 2;
    const bool speaks = large[layer] >= 4 && 10 * labelled[layer] >= 6 * large[layer];
    if ((called_so || speaks) && 10 * large[layer] >= 6 * all[layer] &&
        (!best || labelled[layer] > labelled[*best]))
      best = layer;
  }
  return best;
}

FoundPlan rooms_of_outlines(const Drawing& drawing, std::uint32_t layer, FoundPlans& found) {
  FoundPlan plan;
  DrawnBox all;
  for (const DrawnRing& ring : drawing.rings) {
    if (ring.layer != layer) continue;
    const double area = std::abs(signed_area(ring.corners));
    const InscribedCircle circle = inscribed_circle({{ring.corners}});
    if (area < smallest_room || circle.radius < 0.25) {
      ++found.culled["outlines smaller than a room"];
      continue;
    }
    std::vector<DrawnText> texts;
    for (const DrawnText& text : drawing.texts)
      if (contains(ring.corners, text.at)) texts.push_back(text);
    RoomLabel label = label_of(std::move(texts));
    for (const Vec2 p : ring.corners) all.add(p);
    plan.rooms.push_back(
        {{ring.corners}, area, std::move(label.name), label.area, 0, ring.line, circle.centre});
  }
  plan.low = all.low;
  plan.high = all.high;
  add_named_stairs(plan);
  return plan;
}

}  // namespace docent::import
