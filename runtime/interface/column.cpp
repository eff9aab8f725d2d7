#include "runtime/interface/column.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "runtime/interface/face.h"

namespace docent::interface {
namespace {

/// Draws them from the top down, and gives what is left to the first that can grow.
void draw_blocks(const std::vector<Block>& blocks, const PixelBox& box, float spare) {
  float y = box.y;
  for (const Block& block : blocks) {
    const float own = block.height(box.width);
    const float more = block.most ? std::clamp(block.most(box.width) - own, 0.0F, spare) : 0;
    const float height = std::floor(own + more);
    spare -= more;
    block.draw({box.x, y, box.width, height});
    y += height + (height > 0 ? std::round(block.gap) : 0);
  }
}

constexpr float least_heading = 0.45F;  ///< Of its size: as what is read, about.

std::vector<Block> first_of(const std::vector<Block>& blocks, std::size_t count) {
  return {blocks.begin(),
          blocks.begin() + static_cast<std::ptrdiff_t>(std::min(count, blocks.size()))};
}

/// The controls that turn a part that scrolls, at the ends of its rail.
void draw_turner(Sheet& sheet, std::int32_t control, Pictogram what, const PixelBox& box) {
  sheet.place(control, box);
  sheet.fill(box, sheet.theme().plaster, sheet.measures().corner, control);
  sheet.pictogram(what, box.inset(std::round(0.22F * box.width)), sheet.theme().ink, control);
}

void scroll(Sheet& sheet, const std::vector<Block>& blocks, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const PixelBox rail{box.right() - m.touch, box.y, m.touch, box.height};
  const PixelBox area{box.x, box.y, box.width - m.touch - std::round(m.unit), box.height};
  const Sheet::Mark mark = sheet.mark();
  draw_blocks(blocks, area, 0);
  const std::int32_t up =
      sheet.add_control(button(sheet.museum(), "text-up", "text_up", {Action::Kind::Scroll, 0}));
  const std::int32_t down = sheet.add_control(
      button(sheet.museum(), "text-down", "text_down", {Action::Kind::Scroll, 1}));
  const PixelBox between{rail.x, rail.y + m.touch + m.unit, rail.width,
                         rail.height - 2 * (m.touch + m.unit)};
  sheet.scroll_since(mark, area, height_of(blocks, area.width), between, up, down);
  draw_turner(sheet, up, Pictogram::FurtherUp, {rail.x, rail.y, m.touch, m.touch});
  draw_turner(sheet, down, Pictogram::FurtherDown,
              {rail.x, rail.bottom() - m.touch, m.touch, m.touch});
}

}  // namespace

Block text_block(Sheet& sheet, const TextStyle& style, std::string text, scene::Colour colour,
                 float gap) {
  const auto shared = std::make_shared<const std::string>(std::move(text));
  return {.height = [&sheet, style,
                     shared](float width) { return sheet.height_of(style, *shared, width); },
          .draw =
              [&sheet, style, shared, colour](const PixelBox& box) {
                sheet.text(style, *shared, box.x, box.y, box.width, colour);
              },
          .gap = gap};
}

float height_of(const std::vector<Block>& blocks, float width) {
  float sum = 0, gap = 0;
  for (const Block& block : blocks) {
    const float height = block.height(width);
    if (height <= 0) continue;
    sum += gap + height;
    gap = std::round(block.gap);
  }
  return sum;
}

void lay_out_column(Sheet& sheet, const PixelBox& box, std::vector<Block> body,
                    std::vector<Block> foot, std::size_t lead, std::size_t headed) {
  const Measures& m = sheet.measures();
  const float between = body.empty() || foot.empty() ? 0 : m.gap;
  const float foot_height = height_of(foot, box.width);
  const float spare = box.height - height_of(body, box.width) - between - foot_height;
  if (spare >= 0) {
    draw_blocks(body, {box.x, box.y, box.width, box.height - foot_height - between},
                std::max(0.0F, spare - between));
    return draw_blocks(foot, {box.x, box.bottom() - foot_height, box.width, foot_height}, 0);
  }
  // The last blocks of the foot stay, as many as leave enough to read.
  const float width = box.width - m.touch - std::round(m.unit);
  const std::vector<Block> first_seen = first_of(body, lead), heading = first_of(body, headed);
  const float leading = height_of(first_seen, width);
  sheet.shrink_headings(least_heading);
  const float least_headed = height_of(heading, width);
  sheet.shrink_headings(1);
  const float enough = std::max(2 * m.touch + m.unit, std::min(4 * m.touch, 0.4F * box.height));
  std::size_t staying = 0;
  float height = 0;
  for (std::size_t i = foot.size(); i-- > 0; ++staying) {
    const std::vector<Block> last(foot.begin() + static_cast<std::ptrdiff_t>(i), foot.end());
    const float higher = height_of(last, box.width);
    const float least = std::max(staying == 0 ? enough : std::max(enough, leading), least_headed);
    if (box.height - higher - m.gap < least) break;
    height = higher;
  }
  const auto first = foot.end() - static_cast<std::ptrdiff_t>(staying);
  if (!body.empty() && first != foot.begin()) body.back().gap = m.gap;
  std::move(foot.begin(), first, std::back_inserter(body));
  foot.erase(foot.begin(), first);
  draw_blocks(foot, {box.x, box.bottom() - height, box.width, height}, 0);
  const float seen = box.height - height - (height > 0 ? m.gap : 0);
  for (const float share : {0.9F, 0.8F, 0.7F, 0.6F, 0.5F, least_heading})
    if (height_of(heading, width) > seen) sheet.shrink_headings(share);
  scroll(sheet, body, {box.x, box.y, box.width, seen});
  sheet.shrink_headings(1);
}

}  // namespace docent::interface
