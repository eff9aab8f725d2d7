/// What one may listen to at an exhibit.
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

#include "runtime/interface/button_grid.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/pictures.h"

namespace docent::interface {
namespace {

/// Units below the words, for the line that shows how much has been heard (overlay_texts.cpp).
constexpr float room_of_line = 1.75F;

void draw_listen_button(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const scene::Colour ink = sheet.theme().ink;
  const float side = std::round(0.62F * m.touch), aside = side + 2 * m.unit;
  sheet.place(control, box);
  sheet.fill(box, sheet.theme().plaster, m.corner, control);
  sheet.pictogram(Pictogram::Speak, {box.x + m.unit, box.y, side, box.height}, ink, control);
  const float width = box.width - aside - m.unit;
  const float words =
      sheet.extent(sheet.word_style(control, width), sheet.label_of(control), width).height;
  const float up = std::max(0.0F, room_of_line * m.unit - (box.height - words) / 2);
  sheet.control_word(control, {box.x + aside, box.y, width, std::floor(box.height - 2 * up)},
                     Align::Start, ink);
}

/// Its button, across the column.
Block listen_block(Sheet& sheet, std::int32_t control, float gap) {
  const auto grid = [&sheet, control](float width) {
    return grid_of(sheet, std::span(&control, 1),
                   {.width = width,
                    .margin = sheet.signed_margin(),
                    .gap = sheet.measures().gap,
                    .above = std::ceil(room_of_line * sheet.measures().unit),
                    .fills = true,
                    .least = 0});
  };
  return {
      .height = [grid](float width) { return grid(width).height(); },
      .draw = [&sheet, control](const PixelBox& box) { draw_listen_button(sheet, control, box); },
      .gap = gap};
}

/// What is said in it, for who cannot hear it.
std::string transcript_of(const Sheet& sheet, std::uint32_t sound) {
  std::string text;
  for (const SoundCue& cue : cues_of_sound(sheet.museum(), sound, sheet.request().state.language))
    text.append(text.empty() ? "" : "\n").append(cue.text);
  return text;
}

}  // namespace

std::vector<Block> sound_blocks(Sheet& sheet) {
  const InterfaceState& state = sheet.request().state;
  const Museum& museum = sheet.museum();
  const Measures& m = sheet.measures();
  std::vector<Block> blocks;
  if (!state.arrived || !state.exhibit || *state.exhibit >= museum.exhibits.size()) return blocks;
  const std::span<const ExhibitSound> sounds = sounds_of(museum, *state.exhibit);
  const auto add = [&](Letters letters, std::string text, float gap) {
    blocks.push_back(
        text_block(sheet, sheet.style(letters), std::move(text), sheet.theme().quiet_ink, gap));
  };
  for (std::size_t i = 0; i < sounds.size(); ++i) {
    const std::string heard(sheet.local(sounds[i].description));
    if (const auto control = sheet.control("sound:" + std::to_string(i + 1)); control >= 0) {
      blocks.push_back(listen_block(sheet, control, std::round(m.unit / 2)));
      add(Letters::Small, heard, m.unit);
      continue;
    }
    const auto index = static_cast<std::uint32_t>(&sounds[i] - museum.sounds.data());
    const std::string said = transcript_of(sheet, index);
    add(Letters::Small, std::string(sheet.local(sounds[i].title)), 0);
    add(Letters::Body, heard, said.empty() ? m.unit : 0);
    if (!said.empty()) add(Letters::Body, said, m.unit);
  }
  return blocks;
}

}  // namespace docent::interface
