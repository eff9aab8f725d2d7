/// "Are you still here?", over the middle of the model.
#include <algorithm>
#include <cmath>

#include "runtime/interface/parts.h"

namespace docent::interface {

void draw_still_here(Sheet& sheet, const PixelBox& free) {
  const Measures& m = sheet.measures();
  View& view = sheet.view();
  view.labels.clear();  // it lies where they are
  for (Control& control : view.controls) control.rect = {};
  view.scroll.controls.clear();
  for (std::int32_t* turner : {&view.scroll.up, &view.scroll.down}) {
    if (*turner >= 0) view.controls[static_cast<std::size_t>(*turner)].enabled = false;
    *turner = -1;
  }

  const float ring = std::round(std::max(2 * m.touch, 16 * m.unit));
  const float width = std::round(std::min(free.width - 2 * m.margin, 78 * m.unit));
  const float text_width = width - ring - 3 * m.margin;
  const TextPiece question =
      sheet.set(sheet.heading_style(Letters::Heading, sheet.word("still_here"), text_width),
                sheet.word("still_here"), text_width);
  const Block stay = buttons_block(sheet, {{sheet.control("stay"), Sheet::Emphasis::Strong}}, 0);
  const float button = stay.height(width - 2 * m.margin);
  const float height = std::max(question.height, ring) + button + 2 * m.margin + 2 * m.gap;
  const PixelBox card{std::round(free.x + (free.width - width) / 2),
                      std::round(free.y + (free.height - height) / 2), width, height};
  sheet.shadow(card, 4 * m.unit, 0.16F);
  sheet.fill(card, sheet.theme().paper, m.corner);

  const PixelBox content = card.inset(m.margin);
  const float row = std::max(question.height, ring);
  view.countdown = sheet.share_of({content.x, content.y + (row - ring) / 2, ring, ring});
  const float x = content.x + ring + m.margin;
  sheet.piece(question, x, content.y + (row - question.height) / 2, content.right() - x,
              Align::Start, sheet.theme().ink);
  stay.draw({content.x, content.bottom() - button, content.width, button});
}

}  // namespace docent::interface
