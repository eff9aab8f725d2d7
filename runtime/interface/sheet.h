#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/interface/layout.h"
#include "runtime/interface/pictogram.h"
#include "runtime/scene/theme.h"

namespace docent::interface {

enum class Align : std::uint8_t { Start, Centre, End };

/// What letters are used for, each with the height of its capitals on the glass in millimetres.
enum class Letters : std::uint8_t {
  Small,    ///< Names of galleries, numbers: 5.
  Body,     ///< What an exhibit has to say: 5.
  Item,     ///< What a list holds: 5.4, medium.
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
  const scene::Theme& theme() const noexcept { return theme_; }
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

  TextStyle style(Letters letters, std::uint16_t max_lines = 1) const noexcept;
  /// A text that is at most `width` wide, set smaller, down to 7/10, where it does not fit.
  TextPiece fitted(TextStyle style, std::string_view text, float width);

  void fill(const PixelBox& box, scene::Colour colour, float corner, std::int32_t control = -1);
  /// An edge that is seen on paper.
  void outline(const PixelBox& box, std::int32_t control);
  /// What is chosen has a ground, and such an edge.
  void mark_selected(const PixelBox& box, std::int32_t control);
  void shadow(const PixelBox& box, float reach, float opacity);
  /// Fills the box, moved to whole pixels, with the middle of the picture, texel for pixel.
  void image(const PixelBox& box, std::uint32_t image, float corner, std::int32_t control = -1);
  /// Shows the whole picture at the box's start, as large as fits; up to a tenth of its height may
  /// be cut off to make it wider. Returns its height.
  float whole_image(const PixelBox& box, std::uint32_t image, float corner);
  /// Fills the box, which lies on whole pixels, with a picture that is drawn when it is not there
  /// yet.
  void drawing(const PixelBox& box, std::string key, const std::function<Pixels()>& draw);
  /// Draws a piece with its top at `y`, aligned within `width` from `x`; returns its bottom.
  float piece(const TextPiece& piece, float x, float y, float width, Align align,
              scene::Colour colour, std::int32_t control = -1);
  /// Sets a text and draws it; returns its bottom.
  float text(Letters letters, std::string_view text, float x, float y, float width,
             scene::Colour colour, std::uint16_t max_lines = 1);

  /// Gives a control its rectangle.
  void place(std::int32_t control, const PixelBox& box);
  /// Fills of buttons.
  enum class Emphasis : std::uint8_t { Plain, Soft, Strong };
  void button(std::int32_t control, const PixelBox& box, Emphasis emphasis);
  /// The same with its word in letters that suit a whole row.
  void button(std::int32_t control, const PixelBox& box, Emphasis emphasis, const TextStyle& word);
  /// The letters in which the words of all these buttons fit: in one line, or smaller in two.
  /// `width`: of a button. Controls that are not there do not count.
  TextStyle row_style(std::span<const std::int32_t> controls, float width) {
    return word_style(controls, width - 2 * button_pad());
  }
  /// A button without a ground, its word small and in two lines where it must be; what is selected
  /// has a ground.
  void quiet_button(std::int32_t control, const PixelBox& box);
  /// A pictogram of so many pixels, to be drawn elsewhere.
  TextPiece sign(Pictogram what, float side) {
    return pieces_.pictogram(what, static_cast<std::uint32_t>(std::max(1.0F, std::round(side))));
  }
  /// A pictogram in the middle of a box, as large as the smaller side.
  void pictogram(Pictogram what, const PixelBox& box, scene::Colour colour,
                 std::int32_t control = -1);
  /// A button with a pictogram before its word, and the letters for a row of them.
  void signed_button(std::int32_t control, Pictogram what, const PixelBox& box,
                     const TextStyle& word);
  TextStyle signed_row_style(std::span<const std::int32_t> controls, float width) {
    return word_style(controls, width - 3 * measures_.unit - sign_side());
  }

  /// What a piece says, as an index into View::words; -1 for a pictogram.
  std::int32_t words_of(const TextPiece& piece);
  scene::Quad quad_of(const TextPiece& piece, float x, float y, float width, Align align,
                      scene::Colour colour) const;
  scene::Rect share_of(const PixelBox& box) const noexcept;
  /// Draws the panel itself: its elements are marked as the panel's.
  void draw_panel(const PixelBox& box);
  /// Begins anew: all is drawn inside this card, with letters of that share of their size, and
  /// finish() mirrors the card in place.
  void lie_on(const PixelBox& card, float letters);
  /// Does a text overlap another?
  bool is_crowded() const;
  /// Mirrors everything where the language runs from right to left.
  void finish();

 private:
  void add(scene::Quad quad, std::int32_t control, std::int32_t words = -1);
  TextStyle word_style(std::span<const std::int32_t> controls, float width);
  TextPiece set(const TextStyle& style, std::string_view text, float width);
  float button_pad() const noexcept { return 1.5F * measures_.unit; }
  float sign_side() const noexcept { return std::round(0.62F * measures_.touch); }

  const Museum& museum_;
  const ViewRequest& request_;
  PieceCache& pieces_;
  const Closures& closed_;
  View& view_;
  const ShownWay* way_;
  Measures measures_;
  scene::Theme theme_;
  float width_, height_, shorter_;
  bool right_to_left_;
  scene::Rect turned_{0, 0, 1, 1};  ///< What finish() mirrors.
  float letters_ = 1;
};

/// Fill in the view of each screen. The sheet's panel has been drawn; `content` is what is inside
/// its margins.
void lay_out_welcome(Sheet& sheet, const PixelBox& content);
void lay_out_choosing(Sheet& sheet, const PixelBox& content);
void lay_out_walking(Sheet& sheet, const PixelBox& content);
void lay_out_arrived(Sheet& sheet, const PixelBox& content);
void lay_out_searching(Sheet& sheet, const PixelBox& content);
/// What of the searching screen lies on the model's lower edge, within `free`: the keys, or what
/// was found where the panel has no room for both. Returns its height, with the gap below it.
float draw_search_board(Sheet& sheet, const PixelBox& free);
/// How many found things a page shows.
std::uint32_t found_per_page(const ScreenShape& shape) noexcept;

/// The same on the card of a seat. The welcome, which nobody has answered yet, gets the whole card.
void lay_out_welcome_card(Sheet& sheet, const PixelBox& card);
void lay_out_picking_card(Sheet& sheet, const PixelBox& content);
void lay_out_choosing_card(Sheet& sheet, const PixelBox& content);
void lay_out_walking_card(Sheet& sheet, const PixelBox& content);
void lay_out_arrived_card(Sheet& sheet, const PixelBox& content);

/// The shared glass: the model, and the cards of those who stand at it.
void lay_out_model(Sheet& sheet);
void lay_out_seat(Sheet& sheet, const PixelBox& card);
/// How many exhibits a page of a card's list shows.
std::uint32_t rows_of_card(const ScreenShape& shape, std::uint32_t seats) noexcept;

/// "Follow me to", the exhibit's name, and how far it is; returns the bottom.
float draw_invitation(Sheet& sheet, const PixelBox& box, Letters title);
/// The way in at most three sentences, as far as there is room; returns the bottom.
float draw_sentences(Sheet& sheet, const PixelBox& box);
/// The small plan with the way, on the model's upper corner.
void draw_inset(Sheet& sheet, const PixelBox& free);
/// "Walk with me" in the model's upper corner, beside the inset plan where there is one.
void draw_walk(Sheet& sheet, const PixelBox& free);
/// On a tour: its name, which stop this is and how long it still takes. Returns what is left of the
/// box below that line.
PixelBox draw_tour_progress(Sheet& sheet, const PixelBox& box);
/// Key of the word above a list.
std::string_view title_of(Listed lists) noexcept;
/// How many stops the visitor's own tour has, and how long it takes, once that is known.
std::string own_tour_line(const Sheet& sheet);
/// What stands below the name of a tour in a list: "Tour, about 12 minutes".
std::string tour_line(const Sheet& sheet, const Tour& tour);
/// The tour that a control of the list begins; null where it is no tour.
const Tour* begun_tour(const Sheet& sheet, const Control& control) noexcept;
/// What the visitor goes to or is at; null where there is nothing.
const Exhibit* chosen_exhibit(const Sheet& sheet) noexcept;
/// The same, where it is a place, and what it is called, whatever it is.
std::optional<PlaceKind> chosen_kind(const Sheet& sheet) noexcept;
std::string goal_title(const Sheet& sheet);
/// What is told of it on arrival: an exhibit's text, and that it has been closed since; where a
/// place is.
std::string goal_text(const Sheet& sheet);
/// The exhibit's picture, or the place's pictogram, as large as fits; returns its height.
float draw_goal(Sheet& sheet, const PixelBox& box);
/// "Closed until 5 p.m."; empty where the exhibit can be seen.
std::string closed_line(const Sheet& sheet, std::uint32_t exhibit);
/// A room, and its floor where that is not the kiosk's.
std::string where_line(const Sheet& sheet, std::uint32_t floor, std::uint32_t room);

/// Columns and rows of the exhibits' list inside the choosing panel's content.
struct ListShape {
  std::uint32_t columns = 1, rows = 1;
  float row_height = 0, row_gap = 0;
  float heading_height = 0;  ///< Above the list.
  float foot_height = 0;     ///< Pages, routes and the bottom row, with the gaps before them.
};
ListShape list_shape(const ScreenShape& shape) noexcept;

/// A stroke in a way's colour, outlined where it would hardly show on the paper colour.
void draw_stroke(Sheet& sheet, const PixelBox& box, scene::Colour colour, float corner,
                 std::int32_t control);

/// The exhibit of a list item: its picture, title and gallery; of a kind of place: its pictogram,
/// name, and where it is.
void draw_card(Sheet& sheet, std::int32_t control, const PixelBox& box);
/// The picture, or pictogram, of what a list item leads to, and the line below its title.
void draw_what(Sheet& sheet, std::int32_t control, const PixelBox& box);
std::string line_of(const Sheet& sheet, const Control& control);
/// A kind's pictogram on a dark tile.
void draw_sign(Sheet& sheet, PlaceKind kind, const PixelBox& box, std::int32_t control = -1);
/// The three route kinds, side by side or one above the other.
enum class Along : std::uint8_t { Row, Column, NarrowColumn };
float draw_routes(Sheet& sheet, const PixelBox& box, Along along);
/// The floors at the far edge of the model, over one another as in a lift, and the name of the one
/// that is shown.
float draw_floors(Sheet& sheet, const PixelBox& free);
/// What helps on every screen, on a strip at the model's lower edge; returns its height, with the
/// gap below it.
float draw_helps(Sheet& sheet, const PixelBox& free);
/// Asks whether somebody is still there, over the middle of the model, with room for a ring that
/// counts the seconds. Nothing else can be touched meanwhile.
void draw_still_here(Sheet& sheet, const PixelBox& free);
/// Languages in a row, or what leads to the list of them; in as many rows as they take, from the
/// content's bottom up, whose top is returned; and one of them.
void draw_languages(Sheet& sheet, const PixelBox& box);
float draw_language_rows(Sheet& sheet, const PixelBox& content);
void draw_language(Sheet& sheet, std::int32_t control, const PixelBox& box, Align align);
/// Languages at the start and the given button at the end of the lowest row; returns its top.
float draw_foot(Sheet& sheet, const PixelBox& content, std::string_view button_name);

}  // namespace docent::interface
