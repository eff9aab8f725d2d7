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
constexpr std::array helps{
    Help{"step-free", Pictogram::StepFree}, Help{"no-escalators", Pictogram::NoEscalators},
    Help{"speak", Pictogram::Speak},        Help{"toilets", pictogram_of(PlaceKind::Toilets)},
    Help{"places", Pictogram::Places},      Help{"exhibits", Pictogram::Exhibits}};

/// What a way must not have, where the building has it.
void add_avoidances(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  const bool chooses_way =
      state.screen == Screen::Walking || (state.screen == Screen::Choosing && !state.seat);
  if (!chooses_way) return;
  const auto add = [&](std::string name, std::string_view key, Action::Kind kind, bool is_on) {
    Control control = button(museum, std::move(name), key, {kind, is_on ? 0U : 1U});
    control.selected = is_on;
    out.push_back(std::move(control));
  };
  if (!std::ranges::all_of(museum.connections, &Connection::step_free))
    add("step-free", "step_free", Action::Kind::AvoidSteps, state.ways.step_free);
  if (std::ranges::find(museum.connections, ConnectionKind::Escalator, &Connection::kind) !=
      museum.connections.end())
    add("no-escalators", "no_escalators", Action::Kind::AvoidEscalators, state.ways.no_escalators);
}

/// On a glass of one's own: several visitors would talk over each other.
void add_reading_aloud(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  if (state.glass != Glass::Whole) return;
  Control control =
      button(museum, "speak", "speak", {Action::Kind::ReadAloud, state.speaks ? 0U : 1U});
  control.selected = state.speaks;
  out.push_back(std::move(control));
}

}  // namespace

void add_helps(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  add_avoidances(request, out);
  add_reading_aloud(request, out);
  if (museum.places.empty()) return;
  if (has_place(museum, PlaceKind::Toilets)) {
    Control toilets = button(museum, "toilets", word_of(PlaceKind::Toilets),
                             {Action::Kind::Seek, static_cast<std::uint32_t>(PlaceKind::Toilets)});
    toilets.selected = state.seeks == PlaceKind::Toilets;
    out.push_back(std::move(toilets));
  }
  if (state.screen == Screen::Picking) return;  // first of all, by whom they are led
  const bool lists_places = state.screen == Screen::Choosing && state.lists == Listed::Places;
  out.push_back(lists_places ? button(museum, "exhibits", "exhibits", {Action::Kind::ShowExhibits})
                             : button(museum, "places", "places", {Action::Kind::ShowPlaces}));
}

float draw_helps(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  std::vector<std::pair<std::int32_t, Pictogram>> shown;
  for (const Help& help : helps)
    if (const std::int32_t control = sheet.control(help.name); control >= 0)
      shown.emplace_back(control, help.pictogram);
  if (shown.empty()) return 0;

  // As wide in every language, so that helps stay where they are. Where there is no room for all
  // beside each other, what is asked of ways comes first, in a row of its own.
  constexpr float ordinary = 26, least = 21;  // units
  const float gap = std::round(m.unit), count = static_cast<float>(shown.size());
  const float scale = sheet.request().shape.text_scale;
  const float room = free.width - 2 * m.gap - gap;
  const bool in_two = shown.size() > 2 && room / count - gap < least * m.unit * scale;
  const float columns = in_two ? 2 : count;
  const float each =
      std::min(std::floor(room / columns) - gap, std::round(ordinary * m.unit * scale));
  const auto row_count = static_cast<float>(in_two ? (shown.size() + 1) / 2 : 1);
  const float width = columns * (each + gap) + gap, height = row_count * (m.touch + gap) + gap;
  const PixelBox board{free.right() - m.gap - width, free.bottom() - m.gap - height, width, height};
  sheet.shadow(board, 2 * m.unit, 0.12F);
  sheet.fill(board, sheet.theme().paper, m.corner);
  // From the end: what is on every screen stays in its place.
  std::vector<std::int32_t> controls;
  for (const auto& one : shown) controls.push_back(one.first);
  const TextStyle word = sheet.signed_row_style(controls, each);
  PixelBox cell{board.right() - gap - each, board.bottom() - gap - m.touch, each, m.touch};
  float left = columns;
  for (auto one = shown.rbegin(); one != shown.rend(); ++one) {
    sheet.signed_button(one->first, one->second, cell, word);
    cell.x -= each + gap;
    if (--left > 0) continue;
    left = columns;
    cell.x = board.right() - gap - each;
    cell.y -= m.touch + gap;
  }
  return board.height + m.gap;
}

}  // namespace docent::interface
