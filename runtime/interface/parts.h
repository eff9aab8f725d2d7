#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/column.h"
#include "runtime/interface/sheet.h"

namespace docent::interface {

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
void lay_out_searching_card(Sheet& sheet, const PixelBox& content);

/// The shared glass: the model, and the cards of those who stand at it.
void lay_out_model(Sheet& sheet);
void lay_out_seat(Sheet& sheet, const PixelBox& card);
/// How many exhibits a page of a card's list shows, at least six.
std::uint32_t rows_of_card(const ScreenShape& shape, std::uint32_t seats,
                           std::uint32_t seat) noexcept;

/// On a tour, where one is on it; "follow me to", the exhibit's name, and how far it is; or why one
/// is not led there.
std::vector<Block> invitation_blocks(Sheet& sheet, Letters title);
/// The way in at most three sentences.
std::vector<Block> sentence_blocks(Sheet& sheet);
/// What is told on arrival: where one is on a tour, the name, and the text.
std::vector<Block> goal_blocks(Sheet& sheet, Letters title);
/// The exhibit's picture, or the place's pictogram, at least so high, and larger where there is
/// room; where that is less than `worthwhile`, none.
Block picture_block(Sheet& sheet, float least, float worthwhile, float gap);
/// The same where one leafs through an exhibit's pictures: between two buttons, and below them
/// which one this is, and its caption. As high for all of them, so that the buttons stay in place.
std::vector<Block> picture_blocks(Sheet& sheet, float least, float worthwhile, float gap);
/// Adds them to what is told of an exhibit: above its name. Where not all of it has room above the
/// foot and there is something to listen to, below that, so that its button is seen before anything
/// scrolls. Returns how many blocks have to be seen then.
std::size_t add_pictures(Sheet& sheet, const PixelBox& content, const std::vector<Block>& foot,
                         std::vector<Block>& told);
/// What one may listen to at the exhibit: a button for each and what is heard. Where nothing can be
/// heard, that is read, and what is said in it.
std::vector<Block> sound_blocks(Sheet& sheet);
/// The exhibit's name and its longer text.
std::vector<Block> more_blocks(Sheet& sheet, Letters title);
/// The small plan with the way, on the model's upper corner.
void draw_inset(Sheet& sheet, const PixelBox& free);
/// The same on a card, turned as the model is seen from there.
void draw_plan_on_card(Sheet& sheet, const PixelBox& box);
/// "Walk with me" in the model's upper corner, beside the inset plan where there is one.
void draw_walk(Sheet& sheet, const PixelBox& free);
/// On a tour: its name, which stop this is and how long it still takes; else nothing.
std::string tour_progress(const Sheet& sheet);
/// The items of the list, in two columns where `content` has room for them.
std::vector<Block> list_blocks(Sheet& sheet, const PixelBox& content);
/// The controls of the list, in its order.
std::vector<std::int32_t> list_items(const Sheet& sheet);
/// Plus or minus: whether a touch puts an exhibit into the visitor's own tour, or takes it out.
void draw_collect(Sheet& sheet, std::int32_t control, const PixelBox& box);
/// A heading, whose words are broken only where they are wider than the column.
Block heading_block(Sheet& sheet, Letters letters, std::string text, scene::Colour colour,
                    float gap);
/// Key of the word above a list.
std::string_view title_of(Listed lists) noexcept;
/// How many stops the visitor's own tour has, and how long it takes, once that is known.
std::string own_tour_line(const Sheet& sheet);
/// What stands below the name of a tour in a list: "Tour, about 12 minutes"; of one for who has so
/// much time, how many stops it has and how long it takes.
std::string tour_line(const Sheet& sheet, const Tour& tour);
/// How much time one may have: "15 · 30 · 60 minutes".
std::string times_line(const Sheet& sheet);
/// What the visitor goes to or is at; null where there is nothing.
const Exhibit* chosen_exhibit(const Sheet& sheet) noexcept;
/// The same, where it is a place, and what it is called, whatever it is.
std::optional<PlaceKind> chosen_kind(const Sheet& sheet) noexcept;
std::string goal_title(const Sheet& sheet);
/// What is told of it on arrival: an exhibit's text, and that it has been closed since; where a
/// place is.
std::string goal_text(const Sheet& sheet);
/// The exhibit's picture, or the place's pictogram, as large as fits; returns its height.
float draw_goal(Sheet& sheet, const PixelBox& box, Align align = Align::Start);
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
/// name, and where it is. As high as its texts need, and as its picture, which is `picture` high.
Block card_block(Sheet& sheet, std::int32_t control, float gap);
float height_of_card(Sheet& sheet, std::int32_t control, float width, float picture);
void draw_card(Sheet& sheet, std::int32_t control, const PixelBox& box, float picture);
/// The picture, or pictogram, of what a list item leads to, and the line below its title.
void draw_what(Sheet& sheet, std::int32_t control, const PixelBox& box);
std::string line_of(const Sheet& sheet, const Control& control);
/// A pictogram on a dark tile; that of a kind of place.
void draw_tile(Sheet& sheet, Pictogram what, const PixelBox& box, std::int32_t control);
void draw_sign(Sheet& sheet, PlaceKind kind, const PixelBox& box, std::int32_t control = -1);
/// The route kinds, side by side where there is room for their words, or one above the other.
enum class Along : std::uint8_t { Row, Column };
Block routes_block(Sheet& sheet, Along along, float gap);
/// Buttons beside each other, or below each other where their words need that. Controls that are
/// not there do not count. `least`: of their height.
struct RowButton {
  std::int32_t control = -1;
  Sheet::Emphasis emphasis = Sheet::Emphasis::Soft;
};
Block buttons_block(Sheet& sheet, std::vector<RowButton> buttons, float gap, float least = 0);
/// The floors at the far edge of the model, over one another as in a lift, and the name of the one
/// that is shown.
float draw_floors(Sheet& sheet, const PixelBox& free);
/// What helps on every screen, on a strip at the model's lower edge; returns its height, with the
/// gap below it.
float draw_helps(Sheet& sheet, const PixelBox& free);
/// Asks whether somebody is still there, over the middle of the model, with room for a ring that
/// counts the seconds. Nothing else can be touched meanwhile.
void draw_still_here(Sheet& sheet, const PixelBox& free);
/// Languages in a row, or in as many as they take, or what leads to the list of them; and one of
/// them.
Block languages_block(Sheet& sheet, float gap);
void draw_language(Sheet& sheet, std::int32_t control, const PixelBox& box, Align align);
/// Languages, and the button of that name.
std::vector<Block> foot_blocks(Sheet& sheet, std::string_view button_name);

}  // namespace docent::interface
