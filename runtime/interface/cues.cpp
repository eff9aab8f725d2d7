#include "runtime/interface/cues.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "runtime/interface/caption.h"
#include "runtime/interface/pages.h"
#include "runtime/model/museum.h"

namespace docent::interface {
namespace {

/// How captions are set in a picture of a size.
struct CueLook {
  TextStyle style;
  float width = 0;  ///< Of the longest line, pixels.
  float pad = 0, most_lines = 1;
};

/// Larger letters are as large as leaves the picture to be seen, and never smaller than usual ones.
CueLook look_of(const Sheet& sheet, const PixelBox& picture, const Language& language) {
  constexpr float most = 3, enough = 2, share = 0.4F;
  CueLook look{.style = sheet.style(Letters::Body), .pad = std::round(sheet.measures().unit)};
  look.style.language = language.tag;
  look.style.right_to_left = language.right_to_left;
  look.style.centred = true;
  look.width = picture.width - 4 * look.pad;
  const float room = share * picture.height - 2 * look.pad;
  const float usual = std::ceil(look.style.size / sheet.request().shape.text_scale);
  const float fitting = std::floor(room / (enough * look.style.line_height));
  look.style.size = std::clamp(fitting, std::min(usual, look.style.size), look.style.size);
  const float line = std::round(look.style.size * look.style.line_height);
  look.most_lines = std::clamp(std::floor(room / std::max(line, 1.0F)), 1.0F, most);
  return look;
}

/// The page of a cue, from and to these seconds.
TimedText page_of(Sheet& sheet, const PixelBox& picture, const CueLook& look, std::string_view page,
                  float begin, float end) {
  while (page.ends_with(' ') || page.ends_with('\n')) page.remove_suffix(1);
  const TextPiece piece = sheet.set(look.style, page, look.width);
  const PixelBox ground{std::round(picture.x + (picture.width - piece.width) / 2) - look.pad,
                        picture.bottom() - 3 * look.pad - piece.height, piece.width + 2 * look.pad,
                        piece.height + 2 * look.pad};
  const float shorter = std::min(sheet.view().pixel_width, sheet.view().pixel_height);
  return {.begin = begin,
          .end = end,
          .ground = {.rect = sheet.share_of(ground),
                     .colour = sheet.theme().ink,
                     .corner = sheet.measures().corner / 2 / shorter},
          .quad = sheet.quad_of(piece, ground.x + look.pad, ground.y + look.pad, piece.width,
                                Align::Start, sheet.theme().paper),
          .words = sheet.words_of(piece)};
}

/// Sets those of a video or a sound, a page at a time.
template <typename Timed>
void set_cues(Sheet& sheet, const PixelBox& on, std::span<const Timed> cues,
              const auto& look_in_language) {
  for (const Timed& cue : cues) {
    const CueLook look = look_in_language(sheet.museum().languages[cue.language]);
    if (look.width < look.style.size) return;
    const auto pages = pages_of(sheet, look.style, cue.text, look.width, look.most_lines);
    float begin = 1e-3F * static_cast<float>(cue.begin);
    const float a_letter = 1e-3F * static_cast<float>(cue.end - cue.begin) /
                           static_cast<float>(std::max<std::size_t>(1, cue.text.size()));
    for (const std::string_view page : pages) {
      const float end = begin + a_letter * static_cast<float>(page.size());
      sheet.view().cues.push_back(page_of(sheet, on, look, page, begin, end));
      begin = end;
    }
  }
}

}  // namespace

void draw_cues(Sheet& sheet, const PixelBox& picture, std::uint32_t index) {
  set_cues(sheet, picture, cues_of(sheet.museum(), index, sheet.request().state.language),
           [&](const Language& language) { return look_of(sheet, picture, language); });
}

void draw_sound_cues(Sheet& sheet, const PixelBox& free, std::uint32_t sound) {
  constexpr float widest = 90, lines = 2;  // units
  const Measures& m = sheet.measures();
  CueLook look{.style = sheet.style(Letters::Body), .pad = m.unit, .most_lines = lines};
  look.style.centred = true;
  look.width = std::floor(std::min(free.width - 2 * m.gap,
                                   widest * m.unit * sheet.request().shape.text_scale)) -
               4 * look.pad;
  const float height = lines * std::round(look.style.size * look.style.line_height) + 2 * look.pad;
  PixelBox on =
      box_above(sheet.view(), sheet.share_of(free), look.width + 4 * look.pad, height, m.gap);
  on.height += 2 * look.pad;  // which page_of() leaves below it
  set_cues(sheet, on, cues_of_sound(sheet.museum(), sound, sheet.request().state.language),
           [&](const Language& language) {
             look.style.language = language.tag;
             look.style.right_to_left = language.right_to_left;
             return look;
           });
}

}  // namespace docent::interface
