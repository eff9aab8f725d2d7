/// What stands on the panel of each screen.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "runtime/interface/button_grid.h"
#include "runtime/interface/cues.h"
#include "runtime/interface/goal.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/pictures.h"
#include "runtime/interface/places.h"

namespace docent::interface {

Block heading_block(Sheet& sheet, Letters letters, std::string text, scene::Colour colour,
                    float gap) {
  const auto shared = std::make_shared<const std::string>(std::move(text));
  return {.height =
              [&sheet, letters, shared](float width) {
                return sheet.height_of(sheet.heading_style(letters, *shared, width), *shared,
                                       width);
              },
          .draw =
              [&sheet, letters, shared, colour](const PixelBox& box) {
                sheet.text(sheet.heading_style(letters, *shared, box.width), *shared, box.x, box.y,
                           box.width, colour);
              },
          .gap = gap};
}

namespace {

/// In portrait the wide panel has two columns.
std::pair<PixelBox, PixelBox> halves(const PixelBox& content, float gap, float share) noexcept {
  const float left = std::round((content.width - gap) * share);
  return {{content.x, content.y, left, content.height},
          {content.x + left + gap, content.y, content.width - left - gap, content.height}};
}

struct CountedLine {
  float metres = 0;
  std::string text;
};

/// Before the guide has gone any of it. The way's sentences say figures too, those of the way from
/// the kiosk: where that is the guide's way, they are the same here, and of another way no time is
/// said, because nobody would know which of two is theirs.
std::string whole_line(const Sheet& sheet, const RouteSummary& summary) {
  constexpr double same = 2, same_share = 0.1;  // metres; of the way
  const Museum& museum = sheet.museum();
  const std::uint32_t language = sheet.request().state.language;
  double metres = summary.metres, seconds = summary.seconds;
  if (const ShownWay* way = sheet.way()) {
    const double apart = std::abs(way->directions.metres - metres);
    if (apart > std::max(same, same_share * metres))
      return filled_in(sheet.word("remaining"), "distance", distance_in(museum, language, metres));
    metres = way->directions.metres;
    seconds = way->directions.seconds;
  }
  const std::string line =
      filled_in(sheet.word("distance_and_time"), "distance", distance_in(museum, language, metres));
  return filled_in(line, "time", time_in(museum, language, seconds));
}

/// The metres still to go, ready for every moment of the walk: every metre when near, every five
/// when far.
std::vector<CountedLine> remaining_lines(const Sheet& sheet, const RouteSummary& summary) {
  const Museum& museum = sheet.museum();
  const std::uint32_t language = sheet.request().state.language;
  std::vector<CountedLine> lines;
  constexpr double near = 10, coarse = 5;
  double metres = 1;
  while (metres < summary.metres) {
    lines.push_back({static_cast<float>(metres),
                     metres < 3 ? std::string(sheet.word("nearly_there"))
                                : filled_in(sheet.word("remaining"), "distance",
                                            distance_in(museum, language, metres))});
    metres += metres < near ? 1 : coarse;
  }
  lines.push_back({1e9F, whole_line(sheet, summary)});
  return lines;
}

/// As high as the longest of them.
Block remaining_block(Sheet& sheet, const RouteSummary& summary) {
  TextStyle style = sheet.style(Letters::Lead);
  style.tabular = true;
  const auto lines =
      std::make_shared<const std::vector<CountedLine>>(remaining_lines(sheet, summary));
  return {.height =
              [&sheet, style, lines](float width) {
                float height = 0;
                for (const CountedLine& line : *lines)
                  height = std::max(height, sheet.extent(style, line.text, width).height);
                return height;
              },
          .draw =
              [&sheet, style, lines](const PixelBox& box) {
                for (const CountedLine& line : *lines) {
                  const TextPiece piece = sheet.set(style, line.text, box.width);
                  sheet.view().remaining.push_back({line.metres,
                                                    sheet.quad_of(piece, box.x, box.y, box.width,
                                                                  Align::Start, sheet.theme().ink),
                                                    sheet.words_of(piece)});
                }
              },
          .gap = sheet.measures().gap};
}

/// Why there is no way, and who can help.
std::string no_way_text(const Sheet& sheet, const RouteSummary& summary) {
  const std::optional<Goal> goal = goal_of(sheet.museum(), sheet.request().state);
  if (!summary.hindrance || !goal) return std::string(sheet.word("no_way"));
  const Floor& floor = sheet.museum().floors[goal->floor];
  const std::string_view title = sheet.local(floor.title);
  return filled_in(sheet.word(hindrance_word(*summary.hindrance)), "floor",
                   title.empty() ? std::string_view(floor.plan.short_name) : title);
}

/// What is said where the visitor is not led to what they have chosen: its name, that it is closed
/// and until when, and why there is no way.
struct Refusal {
  std::string title, closed, why;
};
Refusal refusal_of(const Sheet& sheet, const RouteSummary& summary) {
  Refusal refusal{.title = goal_title(sheet), .closed = {}, .why = no_way_text(sheet, summary)};
  const std::optional<std::uint32_t> exhibit = sheet.request().state.exhibit;
  if (summary.hindrance != Hindrance::Exhibit || !exhibit) return refusal;
  const ClosedExhibit* closed = closed_exhibit(sheet.closed(), *exhibit);
  refusal.closed = closed_line(sheet, *exhibit);
  // Where it has just been opened, a way is being looked for.
  refusal.why = closed == nullptr ? sheet.word("planning") : sheet.local(closed->reason);
  return refusal;
}

std::vector<Block> refusal_blocks(Sheet& sheet, const Refusal& refusal, Letters title) {
  const Measures& m = sheet.measures();
  const scene::Theme& theme = sheet.theme();
  return {heading_block(sheet, title, refusal.title, theme.ink, m.unit),
          text_block(sheet, sheet.style(Letters::Lead), refusal.closed, theme.ink, m.unit),
          text_block(sheet, sheet.style(Letters::Body), refusal.why, theme.quiet_ink, m.gap)};
}

void append(std::vector<Block>& blocks, std::vector<Block> more) {
  std::move(more.begin(), more.end(), std::back_inserter(blocks));
}

Block tour_block(Sheet& sheet) {
  return text_block(sheet, sheet.style(Letters::Small), tour_progress(sheet),
                    sheet.theme().quiet_ink, sheet.measures().unit);
}

}  // namespace

std::string_view hindrance_word(Hindrance hindrance) noexcept {
  switch (hindrance) {
    case Hindrance::Door:
      return "closed_door";
    case Hindrance::Stairs:
      return "closed_stairs";
    case Hindrance::Escalator:
      return "closed_escalator";
    case Hindrance::Lift:
      return "closed_lift";
    case Hindrance::Ramp:
      return "closed_ramp";
    case Hindrance::Steps:
      return "only_steps";
    case Hindrance::Escalators:
      return "only_escalators";
    case Hindrance::Exhibit:
      return "closed_now";
  }
  return "no_way";
}

const Exhibit* chosen_exhibit(const Sheet& sheet) noexcept {
  const std::optional<std::uint32_t> exhibit = sheet.request().state.exhibit;
  const auto& all = sheet.museum().exhibits;
  return exhibit && *exhibit < all.size() ? &all[*exhibit] : nullptr;
}

std::optional<PlaceKind> chosen_kind(const Sheet& sheet) noexcept {
  const InterfaceState& state = sheet.request().state;
  const auto& places = sheet.museum().places;
  if (state.place && *state.place < places.size()) return places[*state.place].kind;
  return state.seeks;
}

std::string goal_title(const Sheet& sheet) {
  if (const Exhibit* exhibit = chosen_exhibit(sheet); exhibit != nullptr)
    return std::string(sheet.local(exhibit->title));
  const InterfaceState& state = sheet.request().state;
  const auto& places = sheet.museum().places;
  if (state.place && *state.place < places.size() && !places[*state.place].title.empty())
    return std::string(sheet.local(places[*state.place].title));
  const std::optional<PlaceKind> kind = chosen_kind(sheet);
  return kind ? std::string(sheet.word(word_of(*kind))) : std::string();
}

std::string goal_text(const Sheet& sheet) {
  if (const Exhibit* exhibit = chosen_exhibit(sheet); exhibit != nullptr) {
    std::string told = closed_line(sheet, *sheet.request().state.exhibit);
    const auto add = [&](std::string_view line) {
      if (!told.empty() && !line.empty()) told += '\n';
      told += line;
    };
    if (told.empty() && sheet.request().state.arrived && may_be_touched(exhibit->place))
      add(sheet.word("may_touch"));
    if (!has_picture(sheet.museum(), *exhibit)) add(sheet.local(exhibit->description));
    add(sheet.local(exhibit->text));
    return told;
  }
  const Museum& museum = sheet.museum();
  const std::optional<Goal> goal = goal_of(museum, sheet.request().state);
  if (!goal) return {};
  return where_line(sheet, goal->floor, room_of(museum, goal->floor, goal->position));
}

namespace {

/// How high it is where it is so wide.
float height_of_image(const Museum& museum, std::uint32_t index, float width) noexcept {
  if (index >= museum.images.size() || museum.images[index].width == 0) return 0;
  const EncodedImage& image = museum.images[index];
  return std::floor(width * static_cast<float>(image.height) / static_cast<float>(image.width));
}

/// How high it is where there is room: as the highest of an exhibit's pictures, if it has any.
float height_of_goal(Sheet& sheet, float width) {
  if (const Exhibit* exhibit = chosen_exhibit(sheet); exhibit != nullptr) {
    const Museum& museum = sheet.museum();
    if (!is_pictured(museum, *sheet.request().state.exhibit)) return 0;
    float height = height_of_image(museum, exhibit->image, width);
    for (const FurtherPicture& picture : further_pictures(museum, *sheet.request().state.exhibit))
      height = std::max(height, height_of_image(museum, picture.image, width));
    return height;
  }
  return chosen_kind(sheet) ? std::min(width, 40 * sheet.measures().unit) : 0;
}

}  // namespace

float draw_goal(Sheet& sheet, const PixelBox& box, Align align) {
  if (chosen_exhibit(sheet) != nullptr) {
    const InterfaceState& state = sheet.request().state;
    if (!is_pictured(sheet.museum(), *state.exhibit)) return 0;
    const ShownPicture shown = shown_picture(sheet.museum(), state, *state.exhibit);
    const Sheet::DrawnImage drawn =
        sheet.whole_image(box, shown.image, sheet.measures().corner, align);
    if (shown_video(sheet.museum(), state)) {
      sheet.view().video = drawn.texture;
      if (drawn.texture != scene::TextureId::None && shown.further)
        draw_cues(sheet, drawn.box, *shown.further);
    }
    return drawn.height;
  }
  const std::optional<PlaceKind> kind = chosen_kind(sheet);
  const float side = std::round(std::min({box.width, box.height, 40 * sheet.measures().unit}));
  if (!kind || side < 1) return 0;
  draw_sign(sheet, *kind, {box.x, box.y, side, side});
  return side;
}

Block picture_block(Sheet& sheet, float least, float worthwhile, float gap) {
  return {.height = [&sheet, least](float w) { return std::min(least, height_of_goal(sheet, w)); },
          .draw =
              [&sheet, worthwhile](const PixelBox& box) {
                if (box.height >= worthwhile) draw_goal(sheet, box);
              },
          .gap = gap,
          .most = [&sheet](float width) { return height_of_goal(sheet, width); }};
}

std::vector<Block> more_blocks(Sheet& sheet, Letters title) {
  const Measures& m = sheet.measures();
  std::vector<Block> blocks{
      heading_block(sheet, title, goal_title(sheet), sheet.theme().ink, m.unit)};
  const Exhibit* exhibit = chosen_exhibit(sheet);
  if (exhibit == nullptr) return blocks;
  for_each_line(sheet.local(exhibit->more), [&](std::string_view paragraph) {
    blocks.push_back(text_block(sheet, sheet.style(Letters::Body), std::string(paragraph),
                                sheet.theme().ink, m.unit));
  });
  return blocks;
}

std::vector<Block> invitation_blocks(Sheet& sheet, Letters title) {
  const Measures& m = sheet.measures();
  const scene::Theme& theme = sheet.theme();
  std::vector<Block> blocks{tour_block(sheet)};
  std::string name = goal_title(sheet);
  if (name.empty()) return blocks;
  const std::optional<RouteSummary>& summary = sheet.request().route_summary;
  if (summary && summary->status != path::RouteStatus::Ok) {
    append(blocks, refusal_blocks(sheet, refusal_of(sheet, *summary), title));
    return blocks;
  }
  const std::string_view follow =
      sheet.word(chosen_exhibit(sheet) != nullptr ? "follow" : "follow_to_place");
  blocks.push_back(
      text_block(sheet, sheet.style(Letters::Body), std::string(follow), theme.quiet_ink, 0));
  blocks.push_back(heading_block(sheet, title, std::move(name), theme.ink, m.unit));
  blocks.push_back(summary
                       ? remaining_block(sheet, *summary)
                       : text_block(sheet, sheet.style(Letters::Body),
                                    std::string(sheet.word("planning")), theme.quiet_ink, m.gap));
  return blocks;
}

std::vector<Block> goal_blocks(Sheet& sheet, Letters title) {
  const Measures& m = sheet.measures();
  std::vector<Block> blocks{
      heading_block(sheet, title, goal_title(sheet), sheet.theme().ink, m.unit)};
  append(blocks, sound_blocks(sheet));
  blocks.push_back(
      text_block(sheet, sheet.style(Letters::Body), goal_text(sheet), sheet.theme().ink, 0));
  return blocks;
}

namespace {

/// What collects an exhibit of the list is as wide for all: as its words need; where that is too
/// much, a sign stands for them.
float width_of_collect(Sheet& sheet, std::int32_t control, float width) {
  constexpr float most = 0.32F;
  const Measures& m = sheet.measures();
  const TextStyle style = sheet.word_style(control, width);
  float longest = 0;
  for (const std::string_view key : {"own_tour_add", "own_tour_added", "own_tour_remove"})
    longest = std::max(longest, sheet.longest_word(style, sheet.word(key)));
  const float wide = std::max(m.touch, std::ceil(longest + 2 * m.unit));
  return wide <= most * width ? wide : m.touch;
}

/// An item of the list, and what collects it where that is an exhibit.
Block item_block(Sheet& sheet, std::int32_t control, float gap) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.at(control).action;
  const float least = list_shape(sheet.request().shape).row_height;
  if (action.kind == Action::Kind::Speak)
    return {.height = [least](float) { return least; },
            .draw = [&sheet, control](
                        const PixelBox& box) { draw_language(sheet, control, box, Align::Start); },
            .gap = gap};
  const std::int32_t collect =
      action.kind == Action::Kind::Choose ? sheet.collect(action.argument) : -1;
  if (collect < 0) return card_block(sheet, control, gap);
  const float between = std::round(m.unit);
  return {
      .height =
          [&sheet, control, collect, least, between](float width) {
            const float aside = width_of_collect(sheet, collect, width);
            const float room = aside - sheet.measures().unit;
            const float word =
                sheet.extent(sheet.word_style(collect, room), sheet.label_of(collect), room).height;
            const float card = height_of_card(sheet, control, width - aside - between, least);
            return aside > sheet.measures().touch ? std::max(card, word + between) : card;
          },
      .draw =
          [&sheet, control, collect, least, between](const PixelBox& box) {
            const float aside = width_of_collect(sheet, collect, box.width);
            draw_card(sheet, control, {box.x, box.y, box.width - aside - between, box.height},
                      least);
            const PixelBox end{box.right() - aside, box.y, aside, box.height};
            if (aside > sheet.measures().touch) return sheet.quiet_button(collect, end);
            draw_collect(sheet, collect, {end.x, end.y + (end.height - aside) / 2, aside, aside});
          },
      .gap = gap};
}

/// Two items beside each other, as high as the higher one.
Block pair_block(const Block& left, const Block& right, float between, float gap) {
  const auto half = [between](float width) { return std::floor((width - between) / 2); };
  return {.height =
              [left, right, half](float width) {
                return std::max(left.height(half(width)), right.height(half(width)));
              },
          .draw =
              [left, right, half](const PixelBox& box) {
                const float width = half(box.width);
                left.draw({box.x, box.y, width, box.height});
                right.draw({box.right() - width, box.y, width, box.height});
              },
          .gap = gap};
}

}  // namespace

std::vector<Block> list_blocks(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const ListShape list = list_shape(sheet.request().shape);
  std::vector<Block> items;
  for (const std::int32_t control : list_items(sheet))
    items.push_back(item_block(sheet, control, list.row_gap));
  constexpr float least_column = 50;  // units
  const bool in_two = list.columns > 1 &&
                      content.width / 2 >= least_column * m.unit * sheet.request().shape.text_scale;
  if (!in_two) return items;
  const Block none{.height = [](float) { return 0.0F; }, .draw = [](const PixelBox&) {}};
  std::vector<Block> rows;
  const std::size_t half = (items.size() + 1) / 2;
  for (std::size_t i = 0; i < half; ++i)
    rows.push_back(pair_block(items[i], half + i < items.size() ? items[half + i] : none, 2 * m.gap,
                              list.row_gap));
  return rows;
}

namespace {

/// Back and forth, and between them which page this is.
Block pages_block(Sheet& sheet) {
  const InterfaceState& state = sheet.request().state;
  const Museum& museum = sheet.museum();
  const std::uint32_t pages = page_count(museum, state, exhibits_per_page(sheet.request().shape));
  const std::array both{sheet.control("page:previous"), sheet.control("page:next")};
  const std::uint32_t page = std::min(state.page, pages - 1);
  std::string text = filled_in(sheet.word("page_of"), "n",
                               number_in(museum, state.language, static_cast<long>(page) + 1));
  text = filled_in(text, "total", number_in(museum, state.language, static_cast<long>(pages)));
  const auto count = std::make_shared<const std::string>(std::move(text));
  const auto third = [gap = sheet.measures().gap](float width) {
    return std::floor((width - 2 * gap) / 3);
  };
  const auto is_row = [&sheet, both, third](float width) {
    return have_room(sheet, both, third(width) - sheet.button_margin(), 2);
  };
  const Block rows = buttons_block(sheet, {{both[0]}, {both[1]}}, 0);
  const TextStyle style = sheet.style(Letters::Small);
  const auto height_of_count = [&sheet, style, count](float width) {
    return sheet.extent(style, *count, width).height;
  };
  Block pages_row;
  pages_row.gap = sheet.measures().gap;
  pages_row.height = [=, &sheet](float width) {
    if (!is_row(width)) return rows.height(width) + height_of_count(width);
    float height = std::max(sheet.measures().touch, height_of_count(third(width)));
    for (const std::int32_t control : both)
      height = std::max(height, buttons_block(sheet, {{control}}, 0).height(third(width)));
    return height;
  };
  pages_row.draw = [=, &sheet](const PixelBox& box) {
    const bool row = is_row(box.width);
    const float wide = row ? third(box.width) : box.width;
    const float x = row ? box.x + (box.width - wide) / 2 : box.x;
    const float own = height_of_count(wide);
    const TextPiece piece = sheet.set(style, *count, wide);
    const float y = row ? box.y + (box.height - own) / 2 : box.y;
    sheet.piece(piece, x, y, wide, Align::Centre, sheet.theme().quiet_ink);
    if (!row) return rows.draw({box.x, box.y + own, box.width, box.height - own});
    sheet.button(both[0], {box.x, box.y, wide, box.height}, Sheet::Emphasis::Soft);
    sheet.button(both[1], {box.right() - wide, box.y, wide, box.height}, Sheet::Emphasis::Soft);
  };
  return pages_row;
}

}  // namespace

void lay_out_choosing(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const Listed lists = sheet.request().state.lists;
  std::vector<Block> body{heading_block(
      sheet, Letters::Heading, std::string(sheet.word(title_of(lists))), sheet.theme().ink, m.gap)};
  if (lists == Listed::OwnTour)
    body.push_back(text_block(sheet, sheet.style(Letters::Small), own_tour_line(sheet),
                              sheet.theme().quiet_ink, m.unit));
  append(body, list_blocks(sheet, content));

  std::vector<Block> foot;
  if (sheet.control("page:next") >= 0) foot.push_back(pages_block(sheet));
  if (lists == Listed::OwnTour)
    foot.push_back(buttons_block(sheet,
                                 {{sheet.control("start-tour"), Sheet::Emphasis::Strong},
                                  {sheet.control("choose"), Sheet::Emphasis::Soft}},
                                 m.gap));
  else
    foot.push_back(routes_block(sheet, Along::Row, m.gap));
  append(foot, foot_blocks(sheet, sheet.control("back") >= 0 ? "back" : "home"));
  lay_out_column(sheet, content, std::move(body), std::move(foot));
}

namespace {

/// In portrait, where letters leave room for two columns, `left` stands beside the rest, above the
/// last blocks of the foot; else all is in one column, with `left` in its place.
struct TwoColumns {
  std::vector<Block> left, right, right_foot, foot;
  std::size_t headed = 0;  ///< How many blocks at the right there are with the heading.
};
bool lay_out_in_two(Sheet& sheet, const PixelBox& content, const TwoColumns& columns, float share) {
  const Measures& m = sheet.measures();
  if (is_landscape(sheet.request().shape)) return false;
  constexpr float least_column = 50;  // units
  const auto [first, second] = halves(content, 2 * m.margin, share);
  const float foot = height_of(columns.foot, content.width);
  const float room = content.height - foot - m.gap;
  if (second.width < least_column * m.unit * sheet.request().shape.text_scale ||
      room < 5 * m.touch || height_of(columns.left, first.width) > room)
    return false;
  lay_out_column(sheet, {first.x, first.y, first.width, room}, columns.left, {});
  lay_out_column(sheet, {second.x, second.y, second.width, room}, columns.right, columns.right_foot,
                 0, columns.headed);
  lay_out_column(sheet, {content.x, content.bottom() - foot, content.width, foot}, {},
                 columns.foot);
  return true;
}

}  // namespace

void lay_out_walking(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const std::int32_t skip = sheet.control("skip"),
                     collect = sheet.collect(sheet.request().state.exhibit);
  const RowButton middle = skip < 0 ? RowButton{collect, Sheet::Emphasis::Plain}
                                    : RowButton{skip, Sheet::Emphasis::Soft};
  TwoColumns all;
  all.left = invitation_blocks(sheet, Letters::Title);
  append(all.left, sentence_blocks(sheet));
  all.left.push_back(picture_block(sheet, 0, 12 * m.unit, 0));
  if (std::ranges::any_of(sheet.controls(), [](const Control& control) {
        return control.action.kind == Action::Kind::TakeRoute;
      }))
    all.right_foot = {
        text_block(sheet, sheet.style(Letters::Body), std::string(sheet.word("route_title")),
                   sheet.theme().quiet_ink, m.unit),
        routes_block(sheet, Along::Column, m.gap)};
  all.foot = {buttons_block(sheet,
                            {{sheet.control("stop"), Sheet::Emphasis::Strong},
                             middle,
                             {sheet.control("choose"), Sheet::Emphasis::Soft}},
                            m.gap)};
  append(all.foot, foot_blocks(sheet, "home"));
  if (lay_out_in_two(sheet, content, all, 0.5F)) return;
  append(all.right_foot, std::move(all.foot));
  constexpr std::size_t headed = 3;  // the tour, "Follow me to", and the name
  lay_out_column(sheet, content, std::move(all.left), std::move(all.right_foot), 0, headed);
}

void lay_out_arrived(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const bool is_longer = reads_more(sheet.museum(), sheet.request().state);
  TwoColumns all;
  all.left = picture_blocks(sheet, 0, 1, 0);
  all.right = {tour_block(sheet)};
  append(all.right,
         is_longer ? more_blocks(sheet, Letters::Title) : goal_blocks(sheet, Letters::Title));
  const std::vector<std::int32_t> cards = list_items(sheet);
  if (!cards.empty())
    all.right_foot.push_back(
        text_block(sheet, sheet.style(Letters::Small),
                   std::string(sheet.word(sheet.control("next") >= 0 ? "tour_next" : "next_title")),
                   sheet.theme().quiet_ink, std::round(m.unit / 2)));
  for (const std::int32_t card : cards)
    all.right_foot.push_back(
        card_block(sheet, card, card == cards.back() ? m.gap : std::round(m.unit)));
  all.right_foot.push_back(
      buttons_block(sheet,
                    {{sheet.control(is_longer ? "less" : "more"), Sheet::Emphasis::Soft},
                     {sheet.collect(sheet.request().state.exhibit), Sheet::Emphasis::Plain},
                     {sheet.control("choose"), Sheet::Emphasis::Soft}},
                    m.gap));
  all.foot = foot_blocks(sheet, "home");
  all.headed = 2;  // the tour, and the name
  if (lay_out_in_two(sheet, content, all, 0.42F)) return;
  append(all.right_foot, std::move(all.foot));
  const std::size_t told = all.right.size();
  const std::size_t lead = is_longer ? 0 : add_pictures(sheet, content, all.right_foot, all.right);
  if (lead == 0) all.headed += all.right.size() - told;  // pictures above the name
  lay_out_column(sheet, content, std::move(all.right), std::move(all.right_foot), lead, all.headed);
}

}  // namespace docent::interface
