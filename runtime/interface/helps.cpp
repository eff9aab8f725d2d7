/// The strip of helps on the model: what is one touch away from every screen.
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/interface/face.h"
#include "runtime/interface/places.h"

namespace docent::interface {
namespace {

struct Help {
  std::string_view name;
  Pictogram pictogram;
};
constexpr std::array helps{Help{"toilets", pictogram_of(PlaceKind::Toilets)},
                           Help{"places", Pictogram::Places},
                           Help{"exhibits", Pictogram::Exhibits}};

}  // namespace

void add_helps(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  if (museum.places.empty()) return;
  if (has_place(museum, PlaceKind::Toilets)) {
    Control toilets = button(museum, "toilets", word_of(PlaceKind::Toilets),
                             {Action::Kind::Seek, static_cast<std::uint32_t>(PlaceKind::Toilets)});
    toilets.selected = state.seeks == PlaceKind::Toilets;
    out.push_back(std::move(toilets));
  }
  const bool lists_places = state.screen == Screen::Choosing && state.lists_places;
  out.push_back(lists_places
                    ? button(museum, "exhibits", "exhibits", {Action::Kind::ShowExhibits})
                    : button(museum, "places", "places", {Action::Kind::ShowPlaces}));
}

float draw_helps(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  std::vector<std::pair<std::int32_t, Pictogram>> shown;
  for (const Help& help : helps)
    if (const std::int32_t control = sheet.control(help.name); control >= 0)
      shown.emplace_back(control, help.pictogram);
  if (shown.empty()) return 0;

  // As wide in every language, so that helps stay where they are.
  constexpr float ordinary = 26;  // units
  const float gap = std::round(m.unit), count = static_cast<float>(shown.size());
  const float most = std::floor((free.width - 2 * m.gap - gap) / count - gap);
  const float each =
      std::min(most, std::round(ordinary * m.unit * sheet.request().shape.text_scale));
  const float width = count * (each + gap) + gap;
  const PixelBox board{free.right() - m.gap - width, free.bottom() - m.gap - m.touch - 2 * gap,
                       width, m.touch + 2 * gap};
  sheet.shadow(board, 2 * m.unit, 0.12F);
  sheet.fill(board, sheet.theme().paper, m.corner);
  float x = board.x + gap;
  for (const auto& [control, pictogram] : shown) {
    sheet.signed_button(control, pictogram, {x, board.y + gap, each, m.touch});
    x += each + gap;
  }
  return board.height + m.gap;
}

}  // namespace docent::interface
