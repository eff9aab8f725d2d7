#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/layout.h"
#include "runtime/interface/pictogram.h"
#include "runtime/scene/theme.h"

namespace docent::interface {

enum class Align : std::uint8_t { Start, Centre, End };

/// What letters are used for, each with the height of its capitals on the glass in millimetres; on
/// a card of a shared glass all but headings have 5.
enum class Letters : std::uint8_t {
  Small,    ///< Names of galleries, numbers: 5.
  Body,     ///< What an exhibit has to say: 5.
  Item,     ///< What a list holds: 7, medium.
  Label,    ///< Controls: 7, medium.
  Lead,     ///< A sentence that leads on: 7.
  Heading,  ///< A question: 8, serif.
  Title,    ///< An exhibit's name: 11, serif.
  Welcome,  ///< 18, serif.
};

/// Pixels, left to right, origin top left.
struct PixelBox {
  float x = 0, y = 0, width = 0, height = 0;

  float right() const noexcept { return x + width; }
  float bottom() const noexcept { return y + height; }
  PixelBox inset(float by) const noexcept {
    return {x + by, y + by, width - 2 * by, height - 2 * by};
  }
};

/// What a view is drawn on while it is laid out, as if every language ran from left to right;
/// finish() mirrors it for those that do not. Coordinates are pixels of the screen.
class Sheet {
 public:
  Sheet(const Museum& museum, const ViewRequest& request, PieceCache& pieces,
        const Closures& closed, View& view, const ShownWay* way = nullptr);

  const Measures& measures() const noexcept { return measures_; }
  const scene::Theme& theme() const noexcept { return view_.theme; }
  /// The colour of a way or of a guide, as it is seen on this theme's paper.
  scene::Colour on_paper(const scene::Colour& own) const noexcept {
    return scene::lifted(own, view_.theme.least_way);
  }
  const Museum& museum() const noexcept { return museum_; }
  const ViewRequest& request() const noexcept { return request_; }
  const Closures& closed() const noexcept { return closed_; }
  /// Null where none is to be shown.
  const ShownWay* way() const noexcept { return way_; }
  View& view() noexcept { return view_; }

  /// Index of the control of that name; -1 where this view has none. List items before spots.
  std::int32_t control(std::string_view name) const noexcept;
  /// Of what puts an exhibit into the visitor's own tour, or takes it out; -1 where nothing does.
  std::int32_t collect(std::optional<std::uint32_t> exhibit) const noexcept;
  std::string_view word(std::string_view key) const noexcept;
  std::string_view local(const LocalText& text) const noexcept;

  /// Of as many lines as a text takes.
  TextStyle style(Letters letters) const noexcept;
  /// In which the word of a control is set; a language's name in its own letters. Letters that are
  /// larger than usual are so only as far as `width` has room for the longest word.
  TextStyle word_style(std::int32_t control, float width);
  /// From here on words of controls are at most so many times as large as usual.
  void limit_words(float scale) noexcept { most_word_scale_ = scale; }
  /// The same for a heading, which may also be smaller, but never than what is read.
  TextStyle heading_style(Letters letters, std::string_view text, float width);
  /// Headings are that share of their size from here on, and never smaller than what is read.
  void shrink_headings(float share) noexcept { heading_share_ = share; }
  /// A text in lines that are at most `width` wide; and how large that is. It is never set smaller.
  TextPiece set(const TextStyle& style, std::string_view text, float width);
  TextPiece extent(const TextStyle& style, std::string_view text, float width);
  /// How wide its longest word is: in less, that is broken.
  float longest_word(const TextStyle& style, std::string_view text);

  void fill(const PixelBox& box, scene::Colour colour, float corner, std::int32_t control = -1);
  /// An edge that is seen on paper.
  void outline(const PixelBox& box, std::int32_t control);
  /// What is chosen has a ground, and such an edge.
  void mark_selected(const PixelBox& box, std::int32_t control);
  void shadow(const PixelBox& box, float reach, float opacity);
  /// Fills the box, moved to whole pixels, with the middle of the picture, texel for pixel. Returns
  /// the texture that it is in; None where nothing is drawn. `apart`: as PieceCache::picture.
  scene::TextureId image(const PixelBox& box, std::uint32_t image, float corner,
                         std::int32_t control = -1, std::uint32_t apart = 0);
  /// How high it is, drawn or not yet, and its texture as above.
  struct DrawnImage {
    float height = 0;
    scene::TextureId texture = scene::TextureId::None;
    PixelBox box{};  ///< Where it lies.
  };
  /// Shows the whole picture at the box's start, or in its middle, as large as fits; up to a tenth
  /// of its height may be cut off to make it wider.
  DrawnImage whole_image(const PixelBox& box, std::uint32_t image, float corner,
                         Align align = Align::Start);
  /// Fills the box, which lies on whole pixels, with a picture that is drawn when it is not there
  /// yet.
  void drawing(const PixelBox& box, std::string key, const std::function<Pixels()>& draw);
  /// Draws a piece with its top at `y`, aligned within `width` from `x`; returns its bottom.
  float piece(const TextPiece& piece, float x, float y, float width, Align align,
              scene::Colour colour, std::int32_t control = -1);
  /// A text of any length, in as many pieces as it takes: how high it is, and where it ends.
  float height_of(const TextStyle& style, std::string_view text, float width);
  float text(const TextStyle& style, std::string_view text, float x, float y, float width,
             scene::Colour colour, Align align = Align::Start) {
    return text_of(-1, style, text, x, y, width, colour, align);
  }
  /// The same, of a control.
  float text_of(std::int32_t control, const TextStyle& style, std::string_view text, float x,
                float y, float width, scene::Colour colour, Align align = Align::Start);

  /// Gives a control its rectangle.
  void place(std::int32_t control, const PixelBox& box);
  /// Fills of buttons: none, as light as paper with an edge, dark, darkest.
  enum class Emphasis : std::uint8_t { Plain, Light, Soft, Strong };
  void button(std::int32_t control, const PixelBox& box, Emphasis emphasis);
  /// The word of a control in the middle of a box, in lines that are aligned there.
  void control_word(std::int32_t control, const PixelBox& box, Align align, scene::Colour colour);
  const std::vector<Control>& controls() const noexcept { return view_.controls; }
  const Control& at(std::int32_t control) const noexcept {
    return view_.controls[static_cast<std::size_t>(control)];
  }
  std::string_view label_of(std::int32_t control) const noexcept;
  /// How much of a button's width its word leaves free; of one with a pictogram.
  float button_margin() const noexcept { return 2 * button_pad(); }
  float signed_margin() const noexcept { return 3 * measures_.unit + sign_side(); }
  /// In which colour a control without a ground says its word.
  scene::Colour quiet_colour(std::int32_t control) const noexcept;
  /// A button without a ground; what is selected has one.
  void quiet_button(std::int32_t control, const PixelBox& box);
  /// A pictogram of so many pixels, to be drawn elsewhere.
  TextPiece sign(Pictogram what, float side) {
    return pieces_.pictogram(what, static_cast<std::uint32_t>(std::max(1.0F, std::round(side))));
  }
  /// The ground of what lies on the model.
  void board(const PixelBox& box);
  /// A pictogram in the middle of a box, as large as the smaller side.
  void pictogram(Pictogram what, const PixelBox& box, scene::Colour colour,
                 std::int32_t control = -1);
  /// A button with a pictogram before its word.
  void signed_button(std::int32_t control, Pictogram what, const PixelBox& box);

  /// What a piece says, as an index into View::words; -1 for a pictogram.
  std::int32_t words_of(const TextPiece& piece);
  scene::Quad quad_of(const TextPiece& piece, float x, float y, float width, Align align,
                      scene::Colour colour) const;
  scene::Rect share_of(const PixelBox& box) const noexcept;
  /// Draws the panel itself: its elements are marked as the panel's.
  void draw_panel(const PixelBox& box);
  /// All is drawn inside this card, and finish() mirrors it in place.
  void lie_on(const PixelBox& card);
  /// A further control, which only this layout has. The names of controls are known.
  std::int32_t add_control(Control control);
  /// What is drawn and placed from here on, ...
  struct Mark {
    std::size_t elements = 0, placed = 0, counted = 0, cues = 0;
  };
  Mark mark() const noexcept;
  /// ... as far as here, lies in `area`, which scrolls; it is `length` high. One turns it with the
  /// controls `up` and `down`; a thumb runs along `rail`.
  void scroll_since(const Mark& mark, const PixelBox& area, float length, const PixelBox& rail,
                    std::int32_t up, std::int32_t down);
  /// Puts controls in focus order, and mirrors everything where the language runs from right to
  /// left.
  void finish();

 private:
  void add(scene::Quad quad, std::int32_t control, std::int32_t words = -1);
  TextStyle narrowed(TextStyle style, std::string_view text, float width, float least);
  TextStyle in_own_letters(TextStyle look, std::uint32_t index) const noexcept;
  void put_scroll_controls_in_order();
  void turn_over() noexcept;
  float button_pad() const noexcept { return 1.5F * measures_.unit; }
  float sign_side() const noexcept { return std::round(0.62F * measures_.touch); }

  const Museum& museum_;
  const ViewRequest& request_;
  PieceCache& pieces_;
  const Closures& closed_;
  View& view_;
  const ShownWay* way_;
  Measures measures_;
  float most_word_scale_ = 2, heading_share_ = 1;
  float width_, height_, shorter_;
  bool right_to_left_;
  scene::Rect turned_{0, 0, 1, 1};    ///< What finish() mirrors.
  std::vector<std::int32_t> placed_;  ///< Controls, in the order in which they were.
};

}  // namespace docent::interface
