/// An exhibit's pictures where a visitor leafs through them.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/pictures.h"

namespace docent::interface {
namespace {

void draw_leaf_button(Sheet& sheet, std::string_view name, Pictogram what, const PixelBox& box) {
  const std::int32_t control = sheet.control(name);
  if (control < 0) return;
  sheet.place(control, box);
  sheet.fill(box, sheet.theme().plaster, sheet.measures().corner, control);
  sheet.pictogram(what, box.inset(std::round(0.22F * box.width)), sheet.theme().ink, control);
}

/// The picture between its buttons, which point where its language's lines begin and end.
Block between_buttons(Sheet& sheet, const Block& picture, float worthwhile, float gap) {
  const float touch = sheet.measures().touch, aside = touch + std::round(sheet.measures().unit);
  return {.height = [least = picture.height, touch,
                     aside](float width) { return std::max(touch, least(width - 2 * aside)); },
          .draw =
              [&sheet, worthwhile, touch, aside](const PixelBox& box) {
                const bool is_turned =
                    runs_right_to_left(sheet.museum(), sheet.request().state.language);
                const Pictogram back = is_turned ? Pictogram::LeafRight : Pictogram::LeafLeft,
                                on = is_turned ? Pictogram::LeafLeft : Pictogram::LeafRight;
                const float y = std::round(box.y + (box.height - touch) / 2);
                draw_leaf_button(sheet, "picture:previous", back, {box.x, y, touch, touch});
                draw_leaf_button(sheet, "picture:next", on, {box.right() - touch, y, touch, touch});
                if (box.height >= worthwhile)
                  draw_goal(sheet, {box.x + aside, box.y, box.width - 2 * aside, box.height},
                            Align::Centre);
              },
          .gap = gap,
          .most = [most = picture.most, aside](float width) { return most(width - 2 * aside); }};
}

/// "Picture 2 of 5", and what staff have written of it.
std::string line_of_picture(const Sheet& sheet, std::uint8_t leafed) {
  InterfaceState state = sheet.request().state;
  state.picture = leafed;
  const Museum& museum = sheet.museum();
  const ShownPicture shown = shown_picture(museum, state, *state.exhibit);
  const auto number = [&](std::size_t n) {
    return number_in(museum, state.language, static_cast<long>(n));
  };
  std::string line = filled_in(sheet.word("picture_of"), "n", number(shown.number));
  line = filled_in(line, "total", number(shown.count));
  return shown.caption == nullptr ? line : line.append("  ·  ").append(sheet.local(*shown.caption));
}

/// As high as the longest of them.
Block line_block(Sheet& sheet, float gap) {
  const InterfaceState& state = sheet.request().state;
  const std::size_t count = picture_count(sheet.museum(), *state.exhibit);
  const TextStyle style = sheet.style(Letters::Small);
  const auto lines = std::make_shared<std::vector<std::string>>();
  for (std::size_t i = 0; i < count; ++i)
    lines->push_back(line_of_picture(sheet, static_cast<std::uint8_t>(i)));
  Block block = text_block(sheet, style, line_of_picture(sheet, state.picture.value_or(0)),
                           sheet.theme().quiet_ink, gap);
  block.height = [&sheet, style, lines](float width) {
    float height = 0;
    for (const std::string& line : *lines)
      height = std::max(height, sheet.height_of(style, line, width));
    return height;
  };
  return block;
}

}  // namespace

std::vector<Block> picture_blocks(Sheet& sheet, float least, float worthwhile, float gap) {
  const Block picture = picture_block(sheet, least, worthwhile, gap);
  if (sheet.control("picture:next") < 0) return {picture};
  std::vector<Block> blocks{
      between_buttons(sheet, picture, worthwhile, std::round(sheet.measures().unit / 2)),
      line_block(sheet, gap)};
  const std::int32_t play = sheet.control("video:play"), stop = sheet.control("video:stop");
  if (play >= 0 || stop >= 0) blocks.push_back(buttons_block(sheet, {{play}, {stop}}, gap));
  return blocks;
}

std::size_t add_pictures(Sheet& sheet, const PixelBox& content, const std::vector<Block>& foot,
                         std::vector<Block>& told) {
  const Measures& m = sheet.measures();
  const std::vector<Block> seen = picture_blocks(sheet, 24 * m.unit, 1, m.gap);
  const std::vector<Block> before = told;
  told.insert(told.begin() + 1, seen.begin(), seen.end());
  const float needed = height_of(told, content.width) + m.gap + height_of(foot, content.width);
  if (needed <= content.height || sheet.control("sound:1") < 0) return 0;
  const std::size_t sounds = sounds_of(sheet.museum(), *sheet.request().state.exhibit).size();
  const std::size_t name_and_sounds = std::min(before.size(), 2 + 2 * sounds);
  told = before;
  told.insert(told.begin() + static_cast<std::ptrdiff_t>(name_and_sounds), seen.begin(),
              seen.end());
  return 3;  // the tour, the name and the first button
}

}  // namespace docent::interface
