#include "runtime/interface/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/interface/scroll.h"
#include "runtime/model/moving_picture.h"

namespace docent::interface {
namespace {

/// Capitals of Inter and Noto are this share of the letter size high.
constexpr float capital_share = 0.72F;

/// On the card of a shared glass: who reads it stands right at it.
float capitals_mm_on_card(Letters letters) noexcept {
  switch (letters) {
    case Letters::Title:
    case Letters::Welcome:
      return 9;
    case Letters::Heading:
      return 7;
    default:
      return 5;
  }
}

float capitals_mm(Letters letters) noexcept {
  switch (letters) {
    case Letters::Small:
    case Letters::Body:
      return 5;
    case Letters::Item:
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
      width_(static_cast<float>(request.shape.width)),
      height_(static_cast<float>(request.shape.height)),
      shorter_(std::min(width_, height_)),
      right_to_left_(runs_right_to_left(museum, request.state.language)) {
  view_.theme = scene::theme_of(museum.livery, request.state.high_contrast, request.shape.is_night);
}

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

TextStyle Sheet::style(Letters letters) const noexcept {
  const std::string_view language = tag_of(museum_, request_.state.language);
  const bool serif =
      letters == Letters::Heading || letters == Letters::Title || letters == Letters::Welcome;
  TextStyle style;
  style.family = serif ? Family::Serif : Family::Sans;
  style.weight = letters == Letters::Label || letters == Letters::Item ? 500 : 400;
  const float capitals = request_.state.seat ? capitals_mm_on_card(letters) : capitals_mm(letters);
  style.size = std::round(capitals / capital_share * measures_.mm * optical_scale(language) *
                          request_.shape.text_scale);
  style.line_height = serif ? 1.2F : 1.4F;
  if (right_to_left_ || is_tall(language)) style.line_height = serif ? 1.45F : 1.7F;
  style.max_lines = 0;
  style.right_to_left = right_to_left_;
  style.language = language;
  return style;
}

TextStyle Sheet::word_style(std::int32_t control, float width) {
  TextStyle look = style(Letters::Label);
  look.line_height = right_to_left_ || is_tall(look.language) ? 1.4F : 1.15F;
  const Action& action = at(control).action;
  if (action.kind == Action::Kind::Speak && action.argument < museum_.languages.size())
    look = in_own_letters(look, action.argument);
  const float scale = request_.shape.text_scale, usual = std::ceil(look.size / scale);
  if (scale > most_word_scale_)
    look.size = std::max(usual, std::round(look.size * most_word_scale_ / scale));
  return narrowed(look, label_of(control), width, usual);
}

TextStyle Sheet::heading_style(Letters letters, std::string_view text, float width) {
  TextStyle look = style(letters);
  const float least = style(Letters::Body).size;
  look.size = std::max(std::min(least, look.size), std::round(heading_share_ * look.size));
  return narrowed(look, text, width, least);
}

TextStyle Sheet::narrowed(TextStyle style, std::string_view text, float width, float least) {
  const float longest = longest_word(style, text);
  if (longest > width)
    style.size = std::clamp(std::floor(style.size * width / longest), std::min(least, style.size),
                            style.size);
  return style;
}

TextStyle Sheet::in_own_letters(TextStyle look, std::uint32_t index) const noexcept {
  const Language& language = museum_.languages[index];
  look.language = language.tag;
  look.right_to_left = language.right_to_left;
  look.line_height = 1.4F;
  look.size = std::round(look.size / optical_scale(tag_of(museum_, request_.state.language)) *
                         optical_scale(language.tag));
  return look;
}

TextPiece Sheet::set(const TextStyle& style, std::string_view text, float width) {
  return pieces_.text(style, text, static_cast<std::uint32_t>(std::max(1.0F, std::floor(width))));
}

TextPiece Sheet::extent(const TextStyle& style, std::string_view text, float width) {
  return pieces_.extent(style, text, static_cast<std::uint32_t>(std::max(1.0F, std::floor(width))));
}

float Sheet::longest_word(const TextStyle& style, std::string_view text) {
  // One letter, which is as wide as any.
  if (is_without_spaces(style.language)) return pieces_.extent(style, "\u56FD", 0).width;
  float longest = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    if (end > 0) longest = std::max(longest, pieces_.extent(style, text.substr(0, end), 0).width);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return longest + 1;  // it is measured in whole pixels
}

namespace {

/// Longer texts are set a part at a time: no texture is as high as some are.
constexpr std::size_t long_text = 160;
constexpr std::uint16_t lines_of_part = 12;

float line_of(const TextStyle& style) noexcept {
  return std::round(style.size * style.line_height);
}

}  // namespace

float Sheet::height_of(const TextStyle& style, std::string_view text, float width) {
  if (text.empty()) return 0;
  if (text.size() <= long_text) return extent(style, text, width).height;
  TextStyle first = style;
  first.line_count = 1;
  return static_cast<float>(extent(first, text, width).lines) * line_of(style);
}

float Sheet::text_of(std::int32_t control, const TextStyle& style, std::string_view text, float x,
                     float y, float width, scene::Colour colour, Align align) {
  if (text.empty()) return y;
  if (text.size() <= long_text)
    return piece(set(style, text, width), x, y, width, align, colour, control);
  TextStyle part = style;
  part.line_count = lines_of_part;
  std::uint32_t lines = 1;
  for (std::uint32_t first = 0; first < lines; first += lines_of_part) {
    part.first_line = static_cast<std::uint16_t>(first);
    const TextPiece set = this->set(part, text, width);
    lines = set.lines;
    y = piece(set, x, y, width, align, colour, control);
  }
  return y;
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
  fill(box, view_.theme.plaster, measures_.corner, control);
  outline(box, control);
}

void Sheet::outline(const PixelBox& box, std::int32_t control) {
  add({.rect = share_of(box),
       .fill = scene::QuadFill::Frame,
       .colour = view_.theme.quiet_ink,
       .corner = measures_.corner / shorter_,
       .softness = std::max(1.0F, 0.25F * measures_.unit) / shorter_},
      control);
}

void Sheet::shadow(const PixelBox& box, float reach, float opacity) {
  add({.rect = share_of(box),
       .fill = scene::QuadFill::Shadow,
       .colour = scene::with_opacity(view_.theme.shade, opacity),
       .corner = measures_.corner / shorter_,
       .softness = reach / shorter_},
      -1);
}

scene::TextureId Sheet::image(const PixelBox& box, std::uint32_t image, float corner,
                              std::int32_t control, std::uint32_t apart) {
  if (image >= museum_.images.size() || box.width < 1 || box.height < 1)
    return scene::TextureId::None;
  const float x = std::round(box.x), y = std::round(box.y);
  const PixelBox whole{x, y, std::round(box.right()) - x, std::round(box.bottom()) - y};
  const scene::TextureId texture = pieces_.picture(image, static_cast<std::uint32_t>(whole.width),
                                                   static_cast<std::uint32_t>(whole.height), apart);
  if (texture == scene::TextureId::None) return texture;
  add({.rect = share_of(whole),
       .fill = scene::QuadFill::Image,
       .colour = {1, 1, 1, 1},
       .texture = texture,
       .corner = corner / shorter_},
      control);
  return texture;
}

Sheet::DrawnImage Sheet::whole_image(const PixelBox& box, std::uint32_t image, float corner,
                                     Align align) {
  if (image >= museum_.images.size() || museum_.images[image].height == 0) return {};
  const EncodedImage& picture = museum_.images[image];
  constexpr float most_crop = 0.1F;
  const float shape = static_cast<float>(picture.width) / static_cast<float>(picture.height);
  const float widest = box.height * shape / (1 - most_crop);
  const float width = std::round(std::min(box.width, widest));
  const float height = std::round(std::min(box.height, width / shape));
  const float aside = align == Align::Centre ? std::floor((box.width - width) / 2) : 0,
              above = align == Align::Centre ? std::floor((box.height - height) / 2) : 0;
  const PixelBox lies{box.x + aside, box.y + above, width, height};
  const std::uint32_t apart = is_video(picture) ? request_.part : 0;
  return {height, this->image(lies, image, corner, -1, apart), lies};
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

void Sheet::place(std::int32_t control, const PixelBox& box) {
  if (control < 0) return;
  view_.controls[static_cast<std::size_t>(control)].rect = share_of(box);
  placed_.push_back(control);
}

std::string_view Sheet::label_of(std::int32_t control) const noexcept {
  return local(at(control).label);
}

void Sheet::control_word(std::int32_t control, const PixelBox& box, Align align,
                         scene::Colour colour) {
  TextStyle style = word_style(control, box.width);
  style.centred = align == Align::Centre;
  const TextPiece word = set(style, label_of(control), box.width);
  piece(word, box.x, box.y + (box.height - word.height) / 2, box.width, align, colour, control);
}

void Sheet::button(std::int32_t control, const PixelBox& box, Emphasis emphasis) {
  if (control < 0) return;
  place(control, box);
  const Control& it = at(control);
  const bool is_dark = emphasis == Emphasis::Soft || emphasis == Emphasis::Strong;
  if (is_dark && it.enabled)
    fill(box, emphasis == Emphasis::Strong ? view_.theme.ink : view_.theme.quiet_ink,
         measures_.corner, control);
  if (emphasis == Emphasis::Light) mark_selected(box, control);
  scene::Colour colour = is_dark ? view_.theme.paper : view_.theme.ink;
  if (!it.enabled) colour = scene::with_opacity(view_.theme.quiet_ink, 0.35F);
  const float pad = button_pad();
  control_word(control, {box.x + pad, box.y, box.width - 2 * pad, box.height}, Align::Centre,
               colour);
}

scene::Colour Sheet::quiet_colour(std::int32_t control) const noexcept {
  const Control& it = at(control);
  const scene::Colour ink = it.selected ? view_.theme.ink : view_.theme.quiet_ink;
  return it.enabled ? ink : scene::with_opacity(ink, 0.35F);
}

void Sheet::quiet_button(std::int32_t control, const PixelBox& box) {
  if (control < 0) return;
  place(control, box);
  if (at(control).selected) mark_selected(box, control);
  const float pad = std::round(measures_.unit / 2);
  control_word(control, {box.x + pad, box.y, box.width - 2 * pad, box.height}, Align::Centre,
               quiet_colour(control));
}

void Sheet::pictogram(Pictogram what, const PixelBox& box, scene::Colour colour,
                      std::int32_t control) {
  const float side = std::floor(std::min(box.width, box.height));
  if (side < 1) return;
  const TextPiece drawn = pieces_.pictogram(what, static_cast<std::uint32_t>(side));
  piece(drawn, box.x, box.y + (box.height - drawn.height) / 2, box.width, Align::Centre, colour,
        control);
}

void Sheet::signed_button(std::int32_t control, Pictogram what, const PixelBox& box) {
  place(control, box);
  if (at(control).selected) mark_selected(box, control);
  const float side = sign_side(), pad = measures_.unit;
  pictogram(what, {box.x + pad, box.y, side, box.height}, quiet_colour(control), control);
  const float x = box.x + side + 2 * pad;
  control_word(control, {x, box.y, box.right() - pad - x, box.height}, Align::Start,
               quiet_colour(control));
}

void Sheet::board(const PixelBox& box) {
  view_.boards.push_back(share_of(box));
  shadow(box, 2 * measures_.unit, 0.12F);
  fill(box, view_.theme.paper, measures_.corner);
}

void Sheet::draw_panel(const PixelBox& box) {
  view_.panel = share_of(box);
  const std::size_t first = view_.elements.size();
  shadow(box, 4 * measures_.unit, 0.16F);
  fill(box, view_.theme.paper, 0);
  for (std::size_t i = first; i < view_.elements.size(); ++i) view_.elements[i].is_panel = true;
}

void Sheet::lie_on(const PixelBox& card) {
  turned_ = view_.panel = share_of(card);
}

std::int32_t Sheet::add_control(Control control) {
  view_.controls.push_back(std::move(control));
  return static_cast<std::int32_t>(view_.controls.size()) - 1;
}

Sheet::Mark Sheet::mark() const noexcept {
  return {view_.elements.size(), placed_.size(), view_.remaining.size(), view_.cues.size()};
}

void Sheet::scroll_since(const Mark& mark, const PixelBox& area, float length, const PixelBox& rail,
                         std::int32_t up, std::int32_t down) {
  ScrollArea& scroll = view_.scroll;
  scroll.rect = share_of(area);
  scroll.rail = share_of(rail);
  scroll.length = length / height_;
  scroll.fade = std::round(1.5F * measures_.unit) / height_;
  scroll.least = (measures_.touch - 1) / height_;
  scroll.page = std::round(0.8F * area.height) / height_;
  scroll.up = up;
  scroll.down = down;
  for (std::size_t i = mark.elements; i < view_.elements.size(); ++i)
    view_.elements[i].scrolls = true;
  for (std::size_t i = mark.placed; i < placed_.size(); ++i)
    scroll.controls.push_back({placed_[i], at(placed_[i]).rect});
  view_.remaining_scrolls = view_.remaining.size() > mark.counted;
  view_.cues_scroll = view_.cues.size() > mark.cues;
}

/// After what scrolls, or else before all others; till now they were last.
void Sheet::put_scroll_controls_in_order() {
  ScrollArea& scroll = view_.scroll;
  if (!scroll.exists()) return;
  constexpr std::int32_t count = 2;
  std::int32_t place = 0;
  for (const ScrollArea::Scrolled& one : scroll.controls) place = std::max(place, one.control + 1);
  std::rotate(view_.controls.begin() + place, view_.controls.end() - count, view_.controls.end());
  const auto last = static_cast<std::int32_t>(view_.controls.size()) - count;
  const auto moved = [&](std::int32_t& control) {
    if (control >= last)
      control += place - last;
    else if (control >= place)
      control += count;
  };
  for (Element& element : view_.elements) moved(element.control);
  for (FloorLabel& label : view_.labels) moved(label.control);
  for (ScrollArea::Scrolled& one : scroll.controls) moved(one.control);
  moved(scroll.up);
  moved(scroll.down);
}

void Sheet::finish() {
  put_scroll_controls_in_order();
  if (right_to_left_) turn_over();
  place_scrolled(view_, 0);
}

void Sheet::turn_over() noexcept {
  mirror(view_.panel, turned_);
  if (view_.countdown.width > 0) mirror(view_.countdown, turned_);
  if (view_.inset.board.width > 0) mirror(view_.inset.board, turned_);
  for (scene::Rect& board : view_.boards) mirror(board, turned_);
  for (Control& control : view_.controls)
    if (control.rect.width > 0) mirror(control.rect, turned_);
  for (Element& element : view_.elements) mirror(element.quad.rect, turned_);
  if (view_.scroll.exists()) {
    mirror(view_.scroll.rect, turned_);
    mirror(view_.scroll.rail, turned_);
    for (ScrollArea::Scrolled& one : view_.scroll.controls) mirror(one.rect, turned_);
  }
  for (CountedText& text : view_.remaining) mirror(text.quad.rect, turned_);
  for (TimedText& text : view_.cues)
    for (scene::Quad* quad : {&text.ground, &text.quad}) mirror(quad->rect, turned_);
}

}  // namespace docent::interface
