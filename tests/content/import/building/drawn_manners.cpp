#include "tests/content/import/building/drawn_manners.h"

namespace docent::test {
namespace {

DrawingManner on_one_layer(DrawingManner manner) {
  for (std::string* layer :
       {&manner.wall_layer, &manner.door_layer, &manner.text_layer, &manner.furniture_layer,
        &manner.hatch_layer, &manner.dimension_layer, &manner.axis_layer})
    *layer = "0";
  return manner;
}

DrawingManner with_layers(std::string name, std::string wall, std::string door, std::string text,
                          std::string furniture) {
  return {.name = std::move(name),
          .wall_layer = std::move(wall),
          .door_layer = std::move(door),
          .text_layer = std::move(text),
          .furniture_layer = std::move(furniture),
          .furniture = Furniture::Blocks};
}

}  // namespace

void PrintTo(const DrawnManner& drawn, std::ostream* out) {
  *out << drawn.manner.name << ", walls of " << drawn.wall << " m";
}

std::vector<DrawnManner> drawn_manners() {
  const DrawingManner tidy;
  std::vector<DrawnManner> all;
  const auto add = [&](DrawingManner manner, double wall = 0.2) {
    all.push_back({std::move(manner), wall});
  };
  add(tidy);
  add({.name = "thin walls", .doors = DoorsDrawn::Arcs}, 0.1);
  add({.name = "thick walls", .doors = DoorsDrawn::Arcs}, 0.4);
  add({.name = "very thick walls"}, 0.6);
  add({.name = "metres", .metres_per_unit = 1});
  add({.name = "centimetres", .metres_per_unit = 0.01});
  add({.name = "inches", .metres_per_unit = 0.0254});
  add({.name = "feet", .metres_per_unit = 0.3048});
  add({.name = "unit unsaid, mm", .metres_per_unit = 0.001, .states_unit = false});
  add({.name = "unit unsaid, m", .metres_per_unit = 1, .states_unit = false});
  add({.name = "turned 33 degrees", .turn = 0.576});
  add({.name = "mirrored", .mirror = true});
  add({.name = "mirrored, door blocks", .mirror = true, .doors = DoorsDrawn::Blocks});
  add({.name = "far away", .move = {1e6, -2e6}});
  add({.name = "gaps as doors", .doors = DoorsDrawn::Gaps});
  add({.name = "gaps, turned", .turn = 0.3, .doors = DoorsDrawn::Gaps});
  add({.name = "gaps, thin walls", .doors = DoorsDrawn::Gaps}, 0.1);
  add({.name = "gaps, thick walls", .doors = DoorsDrawn::Gaps}, 0.5);
  add({.name = "door blocks", .doors = DoorsDrawn::Blocks});
  add({.name = "sliding doors", .doors = DoorsDrawn::Sliding});
  add({.name = "thresholds", .doors = DoorsDrawn::Thresholds});
  add({.name = "polyline doors", .doors = DoorsDrawn::Polylines});
  add({.name = "furniture blocks", .furniture = Furniture::Blocks});
  add({.name = "furniture lines", .furniture = Furniture::Lines});
  add({.name = "hatch, dims, axes", .hatch = Hatch::Entities, .dimensions = true, .axes = true});
  add({.name = "exploded hatch", .hatch = Hatch::Lines});
  add({.name = "attributes", .texts_are_attributes = true});
  add({.name = "corners open by 1 mm", .gap = 0.001});
  add({.name = "corners open by 1 cm", .gap = 0.01});
  add({.name = "corners open by 5 cm", .gap = 0.05});
  add({.name = "corners overrun by 5 cm", .overshoot = 0.05});
  add({.name = "corners overrun by 20 cm", .overshoot = 0.2});
  add({.name = "crooked by 5 mm", .crooked = 0.005});
  add({.name = "crooked by 2 cm", .crooked = 0.02});
  add({.name = "twice", .copies = 2});
  add({.name = "a hundred times", .copies = 100});
  add({.name = "in pieces", .in_pieces = true});
  add({.name = "polylines", .polylines = true});
  add({.name = "polylines, gaps", .doors = DoorsDrawn::Gaps, .polylines = true});
  add(with_layers("German layers", "WAND", "TUER", "TEXTE", "MOEBEL"));
  add(with_layers("French layers", "MUR", "PORTE", "TEXTES", "MOBILIER"));
  add(with_layers("Spanish layers", "PARED", "PUERTA", "TEXTOS", "MOBILIARIO"));
  add(with_layers("Arabic layers", "جدار", "باب", "نص", "أثاث"));
  add(with_layers("Chinese layers", "墙", "门", "文字", "家具"));
  add(with_layers("Polish layers", "SCIANY", "DRZWI", "OPISY", "MEBLE"));
  add(with_layers("Turkish layers", "DUVAR", "KAPI", "YAZI", "MOBILYA"));
  add(with_layers("Greek layers", "ΤΟΙΧΟΙ", "ΠΟΡΤΕΣ", "ΚΕΙΜΕΝΑ", "ΕΠΙΠΛΑ"));
  add(with_layers("Hebrew layers", "קירות", "דלתות", "טקסט", "ריהוט"));
  add(with_layers("Korean layers", "벽체", "문", "글자", "가구"));
  add(with_layers("Hungarian layers", "FALAK", "AJTO", "FELIRAT", "BUTOR"));
  add(with_layers("layers without meaning", "L1", "L2", "L3", "L4"));
  add(on_one_layer({.name = "one layer"}));
  add(on_one_layer({.name = "one layer, gaps", .doors = DoorsDrawn::Gaps}));
  add(on_one_layer(
      {.name = "one layer, blocks", .doors = DoorsDrawn::Blocks, .furniture = Furniture::Blocks}));
  add(on_one_layer({.name = "one layer, furniture", .furniture = Furniture::Lines}));
  add(on_one_layer({.name = "one layer, dimensions", .dimensions = true}));
  add(on_one_layer({.name = "one layer, hatched", .hatch = Hatch::Lines}));
  add(on_one_layer({.name = "one layer, thresholds", .doors = DoorsDrawn::Thresholds}));
  add(on_one_layer({.name = "one layer, sliding", .doors = DoorsDrawn::Sliding}));
  add(on_one_layer({.name = "one layer, axes", .axes = true}));
  add(on_one_layer({.name = "one layer, polyline doors", .doors = DoorsDrawn::Polylines}));
  return all;
}

}  // namespace docent::test
