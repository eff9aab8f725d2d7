#include "runtime/interface/sheet.h"

#include <algorithm>
#include <cmath>

namespace docent::interface {
namespace {

/// Capitals of Inter and Noto are this share of the letter size high.
constexpr float capital_share = 0.72F;

float capitals_mm(Letters letters) noexcept {
  switch (letters) {
    case Letters::Small:
    case Letters::Body:
      return 5;
    case Letters::Item:
      return 5.4F;
    case Letters::Label:
    case Letters::Lead:
      return 7;
    case Letters::Heading:
      return 8;
    case Letters::Title:
      return 11;
    case Letters::Welcome:
      return 18;
  }
  return 5;
}

/// Arabic letters are small in their em square: this makes them look as large as others of the same
/// size.
float optical_scale(std::string_view language) noexcept {
  if (language.starts_with("ar") || language.starts_with("fa") || language.starts_with("ur"))
    return 1.12F;
  return 1;
}

/// Letters with marks above and below need more room between lines.
bool is_tall(std::string_view language) noexcept {
  return language.starts_with("hi") || language.starts_with("th");
}

/// Lines are broken inside what looks like one long word.
bool is_without_spaces(std::string_view language) noexcept {
  return language.starts_with("ja") || language.starts_with("zh") || language.starts_with("th");
}

std::string_view tag_of(const Museum& museum, std::uint32_t language) noexcept {
  return language < museum.languages.size() ? std::string_view(museum.languages[language].tag)
                                            : std::string_view("en");
}

/// Turns over what is inside `all`.
void mirror(scene::Rect& rect, const scene::Rect& all) noexcept {
  rect.x = 2 * all.x + all.width - rect.x - rect.width;
}

}  // namespace

Sheet::Sheet(const Museum& museum, const ViewRequest& request, PieceCache& pieces,
             const Closures& closed, View& view, const ShownWay* way)
    : museum_(museum),
      request_(request),
      pieces_(pieces),
      closed_(closed),
      view_(view),
      way_(way),
      measures_(measures_of(request.shape)),
      theme_(scene::theme_of(request.state.high_contrast)),
      width_(static_cast<float>(request.shape.width)),
      height_(static_cast<float>(request.shape.height)),
      shorter_(std::min(width_, height_)),
      right_to_left_(runs_right_to_left(museum, request.state.language)) {}

std::int32_t Sheet::control(std::string_view name) const noexcept {
  const auto found = std::ranges::find(view_.controls, name, &Control::name);
  return found == view_.controls.end() ? -1
                                       : static_cast<std::int32_t>(found - view_.controls.begin());
}

std::int32_t Sheet::collect(std::optional<std::uint32_t> exhibit) const noexcept {
  const auto found = std::ranges::find_if(view_.controls, [&](const Control& control) {
    return is_collect(control) && control.action.argument == exhibit;
  });
  return found == view_.controls.end() ? -1
                                       : static_cast<std::int32_t>(found - view_.controls.begin());
}

std::string_view Sheet::word(std::string_view key) const noexcept {
  return interface::word(museum_, request_.state.language, key);
}

std::string_view Sheet::local(const LocalText& text) const noexcept {
  return in_language(museum_, request_.state.language, text);
}

TextStyle Sheet::style(Letters letters, std::uint16_t max_lines) const noexcept {
  const std::string_view language = tag_of(museum_, request_.state.language);
  const bool serif =
      letters == Letters::Heading || letters == Letters::Title || letters == Letters::Welcome;
  TextStyle style;
  style.family = serif ? Family::Serif : Family::Sans;
  style.weight = letters == Letters::Label || letters == Letters::Item ? 500 : 400;
  style.size = std::round(capitals_mm(letters) / capital_share * measures_.mm *
                          optical_scale(language) * request_.shape.text_scale * letters_);
  style.line_height = serif ? 1.2F : 1.4F;
  if (right_to_left_ || is_tall(language)) style.line_height = serif ? 1.45F : 1.7F;
  style.max_lines = max_lines;
  style.right_to_left = right_to_left_;
  style.language = language;
  return style;
}

TextPiece Sheet::fitted(TextStyle style, std::string_view text, float width) {
  const auto most = static_cast<std::uint32_t>(std::max(1.0F, std::floor(width)));
  const float whole = style.size;
  TextPiece piece;
  for (const float scale : {1.0F, 0.9F, 0.8F, 0.7F}) {
    style.size = std::round(whole * scale);
    piece = pieces_.text(style, text, most);
    if (!piece.cut) break;
  }
  return piece;
}

scene::Rect Sheet::share_of(const PixelBox& box) const noexcept {
  return {box.x / width_, box.y / height_, box.width / width_, box.height / height_};
}

void Sheet::add(scene::Quad quad, std::int32_t control, std::int32_t words) {
  view_.elements.push_back({quad, control, words});
}

std::int32_t Sheet::words_of(const TextPiece& piece) {
  if (piece.words.empty()) return -1;
  view_.words.push_back({std::string(piece.words), piece.size * capital_share});
  return static_cast<std::int32_t>(view_.words.size()) - 1;
}

void Sheet::fill(const PixelBox& box, scene::Colour colour, float corner, std::int32_t control) {
  add({.rect = share_of(box), .colour = colour, .corner = corner / shorter_}, control);
}

void Sheet::mark_selected(const PixelBox& box, std::int32_t control) {
  fill(box, theme_.plaster, measures_.corner, control);
  outline(box, control);
}

void Sheet::outline(const PixelBox& box, std::int32_t control) {
  add({.rect = share_of(box),
       .fill = scene::QuadFill::Frame,
       .colour = theme_.quiet_ink,
       .corner = measures_.corner / shorter_,
       .softness = std::max(1.0F, 0.25F * measures_.unit) / shorter_},
      control);
}

void Sheet::shadow(const PixelBox& box, float reach, float opacity) {
  add({.rect = share_of(box),
       .fill = scene::QuadFill::Shadow,
       .colour = scene::with_opacity(theme_.ink, opacity),
       .corner = measures_.corner / shorter_,
       .softness = reach / shorter_},
      -1);
}

void Sheet::image(const PixelBox& box, std::uint32_t image, float corner, std::int32_t control) {
  if (image >= museum_.images.size() || box.width < 1 || box.height < 1) return;
  const float x = std::round(box.x), y = std::round(box.y);
  const PixelBox whole{x, y, std::round(box.right()) - x, std::round(box.bottom()) - y};
  const scene::TextureId texture = pieces_.picture(image, static_cast<std::uint32_t>(whole.width),
                                                   static_cast<std::uint32_t>(whole.height));
  if (texture == scene::TextureId::None) return;
  add({.rect = share_of(whole),
       .fill = scene::QuadFill::Image,
       .colour = {1, 1, 1, 1},
       .texture = texture,
       .corner = corner / shorter_},
      control);
}

float Sheet::whole_image(const PixelBox& box, std::uint32_t image, float corner) {
  if (image >= museum_.images.size() || museum_.images[image].height == 0) return 0;
  const EncodedImage& picture = museum_.images[image];
  constexpr float most_crop = 0.1F;
  const float shape = static_cast<float>(picture.width) / static_cast<float>(picture.height);
  const float widest = box.height * shape / (1 - most_crop);
  const float width = std::round(std::min(box.width, widest));
  const float height = std::round(std::min(box.height, width / shape));
  this->image({box.x, box.y, width, height}, image, corner);
  return height;
}

scene::Quad Sheet::quad_of(const TextPiece& piece, float x, float y, float width, Align align,
                           scene::Colour colour) const {
  const float spare = width - piece.width;
  if (align == Align::Centre) x += spare / 2;
  if (align == Align::End) x += spare;
  const PixelBox box{std::round(x), std::round(y), piece.width, piece.height};
  return {.rect = share_of(box),
          .fill = scene::QuadFill::Text,
          .colour = colour,
          .texture = piece.texture};
}

void Sheet::drawing(const PixelBox& box, std::string key, const std::function<Pixels()>& draw) {
  add({.rect = share_of(box),
       .fill = scene::QuadFill::Image,
       .colour = {1, 1, 1, 1},
       .texture = pieces_.drawing(std::move(key), draw)},
      -1);
}

float Sheet::piece(const TextPiece& piece, float x, float y, float width, Align align,
                   scene::Colour colour, std::int32_t control) {
  if (piece.texture != scene::TextureId::None)
    add(quad_of(piece, x, y, width, align, colour), control, words_of(piece));
  return y + piece.height;
}

float Sheet::text(Letters letters, std::string_view text, float x, float y, float width,
                  scene::Colour colour, std::uint16_t max_lines) {
  return piece(fitted(style(letters, max_lines), text, width), x, y, width, Align::Start, colour);
}

void Sheet::place(std::int32_t control, const PixelBox& box) {
  if (control >= 0) view_.controls[static_cast<std::size_t>(control)].rect = share_of(box);
}

void Sheet::button(std::int32_t control, const PixelBox& box, Emphasis emphasis) {
  button(control, box, emphasis, row_style(std::span(&control, 1), box.width));
}

void Sheet::button(std::int32_t control, const PixelBox& box, Emphasis emphasis,
                   const TextStyle& word) {
  if (control < 0) return;
  place(control, box);
  const Control& it = view_.controls[static_cast<std::size_t>(control)];
  const bool strong = emphasis == Emphasis::Strong;
  const bool plain = emphasis == Emphasis::Plain;
  if (!plain && it.enabled)
    fill(box, strong ? theme_.ink : theme_.quiet_ink, measures_.corner, control);
  scene::Colour colour = plain ? theme_.ink : theme_.paper;
  if (!it.enabled) colour = scene::with_opacity(theme_.quiet_ink, 0.35F);
  const float pad = button_pad(), width = box.width - 2 * pad;
  const TextPiece label = set(word, local(it.label), width);
  piece(label, box.x + pad, box.y + (box.height - label.height) / 2, width, Align::Centre, colour,
        control);
}

void Sheet::quiet_button(std::int32_t control, const PixelBox& box) {
  place(control, box);
  const Control& it = view_.controls[static_cast<std::size_t>(control)];
  if (it.selected) mark_selected(box, control);
  const std::string_view text = local(it.label);
  TextStyle look = style(Letters::Small);
  if (text.find(' ') != std::string_view::npos || is_without_spaces(look.language))
    look.max_lines = 2;
  look.line_height = right_to_left_ ? 1.35F : 1.15F;
  const float pad = std::round(measures_.unit / 2);
  const TextPiece label = fitted(look, text, box.width - 2 * pad);
  const scene::Colour ink = it.selected ? theme_.ink : theme_.quiet_ink;
  piece(label, box.x + pad, box.y + (box.height - label.height) / 2, box.width - 2 * pad,
        Align::Centre, it.enabled ? ink : scene::with_opacity(ink, 0.35F), control);
}

void Sheet::pictogram(Pictogram what, const PixelBox& box, scene::Colour colour,
                      std::int32_t control) {
  const float side = std::floor(std::min(box.width, box.height));
  if (side < 1) return;
  const TextPiece drawn = pieces_.pictogram(what, static_cast<std::uint32_t>(side));
  piece(drawn, box.x, box.y + (box.height - drawn.height) / 2, box.width, Align::Centre, colour,
        control);
}

void Sheet::signed_button(std::int32_t control, Pictogram what, const PixelBox& box,
                          const TextStyle& word) {
  place(control, box);
  const Control& it = view_.controls[static_cast<std::size_t>(control)];
  if (it.selected) mark_selected(box, control);
  const float side = sign_side(), pad = measures_.unit;
  const scene::Colour ink = it.selected ? theme_.ink : theme_.quiet_ink;
  pictogram(what, {box.x + pad, box.y, side, box.height}, ink, control);
  const float x = box.x + side + 2 * pad, width = box.right() - pad - x;
  const TextPiece label = set(word, local(it.label), width);
  piece(label, x, box.y + (box.height - label.height) / 2, width, Align::Start, ink, control);
}

TextPiece Sheet::set(const TextStyle& style, std::string_view text, float width) {
  return pieces_.text(style, text, static_cast<std::uint32_t>(std::max(1.0F, std::floor(width))));
}

TextStyle Sheet::word_style(std::span<const std::int32_t> controls, float width) {
  const TextStyle whole = style(Letters::Label);
  TextStyle look = whole;
  const auto fits = [&](std::int32_t control) {
    return control < 0 ||
           !set(look, local(view_.controls[static_cast<std::size_t>(control)].label), width).cut;
  };
  struct Setting {
    std::uint16_t lines;
    float scale;
  };
  // The largest first, on one line rather than on two.
  for (const auto& [lines, scale] :
       {Setting{1, 1.0F}, Setting{1, 0.9F}, Setting{1, 0.8F}, Setting{2, 0.8F}, Setting{1, 0.72F},
        Setting{2, 0.72F}, Setting{2, 0.64F}, Setting{2, 0.56F}}) {
    look.max_lines = lines;
    look.line_height = lines == 1 ? whole.line_height : 1.1F;
    look.size = std::round(whole.size * scale);
    // Where letters are large, two lines of them are as high as a button only when they are
    // smaller.
    const float ink = (static_cast<float>(lines - 1) * 1.1F + 0.75F) * look.size;
    if (lines > 1 && ink > measures_.touch) continue;
    if (std::ranges::all_of(controls, fits)) return look;
  }
  return look;
}

void Sheet::draw_panel(const PixelBox& box) {
  view_.panel = share_of(box);
  const std::size_t first = view_.elements.size();
  shadow(box, 4 * measures_.unit, 0.16F);
  fill(box, theme_.paper, 0);
  for (std::size_t i = first; i < view_.elements.size(); ++i) view_.elements[i].is_panel = true;
}

void Sheet::lie_on(const PixelBox& card, float letters) {
  turned_ = view_.panel = share_of(card);
  letters_ = letters;
  view_.elements.clear();
  view_.remaining.clear();
}

bool Sheet::is_crowded() const {
  std::vector<scene::Rect> texts;
  for (const Element& element : view_.elements)
    if (element.quad.fill == scene::QuadFill::Text) texts.push_back(element.quad.rect);
  if (!view_.remaining.empty()) texts.push_back(view_.remaining.back().quad.rect);
  const float slack = 2 / height_;  // texts are moved to whole pixels
  const auto overlap = [slack](const scene::Rect& a, const scene::Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y + slack < b.y + b.height &&
           b.y + slack < a.y + a.height;
  };
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(texts[i], texts[j])) return true;
  return false;
}

void Sheet::finish() {
  if (!right_to_left_) return;
  mirror(view_.panel, turned_);
  if (view_.countdown.width > 0) mirror(view_.countdown, turned_);
  if (view_.inset.board.width > 0) mirror(view_.inset.board, turned_);
  for (Control& control : view_.controls)
    if (control.rect.width > 0) mirror(control.rect, turned_);
  for (Element& element : view_.elements) mirror(element.quad.rect, turned_);
  for (CountedText& text : view_.remaining) mirror(text.quad.rect, turned_);
}

}  // namespace docent::interface
