/// The strip of helps on the model: what is one touch away from every screen.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/interface/button_grid.h"
#include "runtime/interface/face.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/places.h"

namespace docent::interface {
namespace {

struct Help {
  std::string_view name;
  Pictogram pictogram;
};
constexpr std::array helps{
    Help{"step-free", Pictogram::StepFree}, Help{"no-escalators", Pictogram::NoEscalators},
    Help{"search", Pictogram::Search},      Help{"toilets", pictogram_of(PlaceKind::Toilets)},
    Help{"places", Pictogram::Places},      Help{"exhibits", Pictogram::Exhibits}};

/// How one sees and hears it: pictograms alone, which need no language.
constexpr std::array senses{Help{"larger", Pictogram::LargerLetters},
                            Help{"contrast", Pictogram::Contrast}, Help{"lower", Pictogram::Lower},
                            Help{"speak", Pictogram::Speak}};

/// What a way must not have, where the building has it.
void add_avoidances(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  const bool chooses_way =
      state.screen == Screen::Walking || (state.screen == Screen::Choosing && !state.seat);
  if (!chooses_way) return;
  const auto add = [&](std::string name, WayChoice choice, Action::Kind kind, bool is_on) {
    const auto offer = std::ranges::find(museum.ways, choice, &WayOffer::choice);
    if (offer == museum.ways.end() && !museum.ways.empty()) return;
    Control control =
        button(museum, std::move(name), info_of(choice).word, {kind, is_on ? 0U : 1U});
    if (offer != museum.ways.end())
      for (const auto& [tag, text] : offer->title) control.label.insert_or_assign(tag, text);
    control.selected = is_on;
    out.push_back(std::move(control));
  };
  if (!std::ranges::all_of(museum.connections, &Connection::step_free))
    add("step-free", WayChoice::StepFree, Action::Kind::AvoidSteps, state.ways.step_free);
  if (std::ranges::find(museum.connections, ConnectionKind::Escalator, &Connection::kind) !=
      museum.connections.end())
    add("no-escalators", WayChoice::NoEscalators, Action::Kind::AvoidEscalators,
        state.ways.no_escalators);
}

/// How one sees and hears the glass; until one leaves. On a glass of one's own: on a shared one
/// cards have no room, and several would be talked to at once.
void add_senses(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  if (state.glass != Glass::Whole) return;
  const auto add = [&](std::string name, std::string_view key, Action::Kind kind, bool is_on) {
    Control control = button(museum, std::move(name), key, {kind, is_on ? 0U : 1U});
    control.selected = is_on;
    out.push_back(std::move(control));
  };
  add("larger", "larger", Action::Kind::EnlargeLetters, state.large_letters);
  add("contrast", "contrast", Action::Kind::RaiseContrast, state.high_contrast);
  if (state.can_lower) add("lower", "lower", Action::Kind::Lower, state.low_reach);
  add("speak", "speak", Action::Kind::ReadAloud, state.speaks);
}

/// What is shown of some helps.
template <std::size_t count>
std::vector<std::pair<std::int32_t, Pictogram>> shown_of(const Sheet& sheet,
                                                         const std::array<Help, count>& all) {
  std::vector<std::pair<std::int32_t, Pictogram>> shown;
  for (const Help& help : all)
    if (const std::int32_t control = sheet.control(help.name); control >= 0)
      shown.emplace_back(control, help.pictogram);
  return shown;
}

using Signs = std::vector<std::pair<std::int32_t, Pictogram>>;

float width_of_signs(const Sheet& sheet, const Signs& shown) {
  const float gap = std::round(sheet.measures().unit);
  return static_cast<float>(shown.size()) * (sheet.measures().touch + gap) + gap;
}

/// Pictograms side by side on a board whose lower corner is given; returns the board.
PixelBox draw_signs_at(Sheet& sheet, const Signs& shown, float right, float bottom) {
  const Measures& m = sheet.measures();
  const float gap = std::round(m.unit), width = width_of_signs(sheet, shown);
  const float height = m.touch + 2 * gap;
  const PixelBox board{right - width, bottom - height, width, height};
  sheet.board(board);
  PixelBox cell{board.x + gap, board.y + gap, m.touch, m.touch};
  for (const auto& [control, pictogram] : shown) {
    sheet.place(control, cell);
    if (sheet.at(control).selected) sheet.mark_selected(cell, control);
    sheet.pictogram(pictogram, cell.inset(std::round(0.2F * m.touch)), sheet.quiet_colour(control),
                    control);
    cell.x += m.touch + gap;
  }
  return board;
}

/// Helps in words: as wide in every language, so that they stay where they are.
ButtonGrid grid_of_helps(Sheet& sheet, const std::vector<std::int32_t>& controls, float width) {
  constexpr float ordinary = 26, wide = 32;  // units
  const Measures& m = sheet.measures();
  const float gap = std::round(m.unit), count = static_cast<float>(controls.size());
  const float room = width - 2 * m.gap - 2 * gap;
  const float unit = m.unit * sheet.request().shape.text_scale;
  const float wanted = std::round(ordinary * unit), in_rows = std::round(wide * unit);
  const float whole = std::min(room, count * (wanted + gap) - gap);
  const auto grid_in = [&](float across) {
    return grid_of(sheet, controls, {.width = across, .margin = sheet.signed_margin(), .gap = gap});
  };
  ButtonGrid grid = grid_in(whole);
  if (grid.columns < controls.size()) {  // what several rows do not need is left to the model
    const auto columns = static_cast<float>(grid.columns);
    ButtonGrid narrower = grid_in(std::min(whole, columns * (in_rows + gap) - gap));
    if (narrower.height() <= grid.height()) return narrower;
  }
  return grid;
}

/// Beside the other strip where there is room, or else above it. Returns how high all of it is.
float draw_senses(Sheet& sheet, const PixelBox& free, const PixelBox& other) {
  const auto shown = shown_of(sheet, senses);
  if (shown.empty()) return free.bottom() - other.y;
  const Measures& m = sheet.measures();
  const bool is_beside = other.x - 2 * m.gap - width_of_signs(sheet, shown) >= free.x;
  const float right = is_beside ? other.x : free.right();
  const float bottom = is_beside || other.height == 0 ? free.bottom() : other.y;
  const PixelBox board = draw_signs_at(sheet, shown, right - m.gap, bottom - m.gap);
  return free.bottom() - std::min(board.y, other.y);
}

}  // namespace

void add_helps(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  add_avoidances(request, out);
  add_senses(request, out);
  const bool can_search = state.seat ? state.screen == Screen::Choosing
                                     : state.glass == Glass::Whole && shows_spots(state.screen);
  if (can_search) out.push_back(button(museum, "search", "search", {Action::Kind::Search}));
  const bool lists_places = state.screen == Screen::Choosing && state.lists == Listed::Places;
  const bool is_away = lists_places || state.screen == Screen::Searching;
  const auto add_exhibits = [&] {
    out.push_back(button(museum, "exhibits", "exhibits", {Action::Kind::ShowExhibits}));
  };
  if (museum.places.empty()) {
    if (is_away) add_exhibits();
    return;
  }
  if (has_place(museum, PlaceKind::Toilets)) {
    Control toilets = button(museum, "toilets", word_of(PlaceKind::Toilets),
                             {Action::Kind::Seek, static_cast<std::uint32_t>(PlaceKind::Toilets)});
    toilets.selected = state.seeks == PlaceKind::Toilets;
    out.push_back(std::move(toilets));
  }
  if (state.screen == Screen::Picking) return;  // first of all, by whom they are led
  if (!lists_places) out.push_back(button(museum, "places", "places", {Action::Kind::ShowPlaces}));
  if (is_away) add_exhibits();
}

float draw_helps(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  const auto shown = shown_of(sheet, helps);
  if (shown.empty()) return draw_senses(sheet, free, {free.right(), free.bottom(), 0, 0});
  std::vector<std::int32_t> controls;
  for (const auto& one : shown) controls.push_back(one.first);

  constexpr float most_height = 0.32F;  // of the model's
  const float scale = sheet.request().shape.text_scale;
  ButtonGrid grid;
  // Where letters are large and the glass is small, they are less large there, so that the model is
  // still seen; a word is never left out.
  for (const float most : {scale, 1.5F, 1.25F, 1.0F}) {
    if (most > scale) continue;
    sheet.limit_words(most);
    grid = grid_of_helps(sheet, controls, free.width);
    if (grid.height() <= most_height * free.height) break;
  }
  const float gap = std::round(m.unit);
  const float across = static_cast<float>(grid.columns) * (grid.width + gap) - gap;
  const float width = across + 2 * gap, height = grid.height() + 2 * gap;
  const PixelBox board{free.right() - m.gap - width, free.bottom() - m.gap - height, width, height};
  sheet.board(board);
  for (std::size_t i = 0; i < shown.size(); ++i)
    sheet.signed_button(shown[i].first, shown[i].second, grid.cell(board.inset(gap), i));
  sheet.limit_words(scale);
  return draw_senses(sheet, free, board);
}

}  // namespace docent::interface
