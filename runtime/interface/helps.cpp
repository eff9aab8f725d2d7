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

/// The strip of pictograms: beside the other one where there is room, or else above it. Returns how
/// high all of it is.
float draw_senses(Sheet& sheet, const PixelBox& free, const PixelBox& other) {
  const auto shown = shown_of(sheet, senses);
  if (shown.empty()) return free.bottom() - other.y;
  const Measures& m = sheet.measures();
  const float gap = std::round(m.unit), count = static_cast<float>(shown.size());
  const float width = count * (m.touch + gap) + gap, height = m.touch + 2 * gap;
  const bool is_beside = other.x - 2 * m.gap - width >= free.x;
  const float right = is_beside ? other.x : free.right();
  const float bottom = is_beside || other.height == 0 ? free.bottom() : other.y;
  const PixelBox board{right - m.gap - width, bottom - m.gap - height, width, height};
  sheet.shadow(board, 2 * m.unit, 0.12F);
  sheet.fill(board, sheet.theme().paper, m.corner);
  PixelBox cell{board.x + gap, board.y + gap, m.touch, m.touch};
  for (const auto& [control, pictogram] : shown) {
    sheet.place(control, cell);
    const bool is_on = sheet.view().controls[static_cast<std::size_t>(control)].selected;
    if (is_on) sheet.mark_selected(cell, control);
    sheet.pictogram(pictogram, cell.inset(std::round(0.2F * m.touch)),
                    is_on ? sheet.theme().ink : sheet.theme().quiet_ink, control);
    cell.x += m.touch + gap;
  }
  return free.bottom() - std::min(board.y, other.y);
}

}  // namespace

void add_helps(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  add_avoidances(request, out);
  add_senses(request, out);
  const bool can_search = state.glass == Glass::Whole && !state.seat && shows_spots(state.screen);
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
  return draw_senses(sheet, free, board);
}

}  // namespace docent::interface
