/// What stands on the panel of each screen.
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/interface/goal.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/places.h"
#include "runtime/interface/sheet.h"

namespace docent::interface {
namespace {

/// In portrait the wide panel has two columns.
std::pair<PixelBox, PixelBox> halves(const PixelBox& content, float gap, float share) noexcept {
  const float left = std::round((content.width - gap) * share);
  return {{content.x, content.y, left, content.height},
          {content.x + left + gap, content.y, content.width - left - gap, content.height}};
}

/// The metres still to go, ready for every moment of the walk: every metre when near, every five
/// when far.
void prepare_remaining(Sheet& sheet, const TextStyle& style, const RouteSummary& route_summary,
                       float x, float y, float width) {
  const Museum& museum = sheet.museum();
  const std::uint32_t language = sheet.request().state.language;
  const auto add = [&](float at, std::string_view text) {
    const TextPiece piece = sheet.fitted(style, text, width);
    sheet.view().remaining.push_back(
        {at, sheet.quad_of(piece, x, y, width, Align::Start, sheet.theme().ink),
         sheet.words_of(piece)});
  };
  constexpr double near = 10, coarse = 5;
  double metres = 1;
  while (metres < route_summary.metres) {
    const std::string text = metres < 3 ? std::string(sheet.word("nearly_there"))
                                        : filled_in(sheet.word("remaining"), "distance",
                                                    distance_in(museum, language, metres));
    add(static_cast<float>(metres), text);
    metres += metres < near ? 1 : coarse;
  }
  std::string whole = filled_in(sheet.word("distance_and_time"), "distance",
                                distance_in(museum, language, route_summary.metres));
  whole = filled_in(whole, "time", time_in(museum, language, route_summary.seconds));
  add(1e9F, whole);
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

/// Sets it as large as there is room for; returns the bottom.
float draw_refusal(Sheet& sheet, const Refusal& refusal, const PixelBox& box, Letters title) {
  struct Sizes {
    Letters title, closed, why;
  };
  const bool on_card = title == Letters::Lead;
  const std::array sizes{
      Sizes{title, on_card ? Letters::Body : Letters::Lead, Letters::Body},
      Sizes{on_card ? Letters::Label : Letters::Heading, Letters::Body, Letters::Body},
      Sizes{Letters::Label, Letters::Body, Letters::Small},
      Sizes{Letters::Small, Letters::Small, Letters::Small}};
  const auto set = [&](Letters letters, const std::string& text, float lines) {
    const auto most = static_cast<std::uint16_t>(std::clamp(lines, 1.0F, 6.0F));
    return text.empty() ? TextPiece{} : sheet.fitted(sheet.style(letters, most), text, box.width);
  };
  for (const Sizes& size : sizes) {
    const bool is_last = &size == &sizes.back();
    const TextPiece name = set(size.title, refusal.title, is_last ? 1 : 2);
    const TextPiece closed = set(size.closed, refusal.closed, 2);
    const float room = box.height - name.height - closed.height;
    const TextStyle style = sheet.style(size.why);
    const float lines = std::floor(room / (style.size * style.line_height));
    const TextPiece why = set(size.why, refusal.why, is_last ? lines : 6);
    if (!is_last && why.height > room) continue;
    float y = sheet.piece(name, box.x, box.y, box.width, Align::Start, sheet.theme().ink);
    y = sheet.piece(closed, box.x, y, box.width, Align::Start, sheet.theme().ink);
    return is_last && lines < 1
               ? y
               : sheet.piece(why, box.x, y, box.width, Align::Start, sheet.theme().quiet_ink);
  }
  return box.y;
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
    const std::string closed = closed_line(sheet, *sheet.request().state.exhibit);
    return closed + (closed.empty() ? "" : "\n") + std::string(sheet.local(exhibit->text));
  }
  const Museum& museum = sheet.museum();
  const std::optional<Goal> goal = goal_of(museum, sheet.request().state);
  if (!goal) return {};
  return where_line(sheet, goal->floor, room_of(museum, goal->floor, goal->position));
}

float draw_goal(Sheet& sheet, const PixelBox& box) {
  if (const Exhibit* exhibit = chosen_exhibit(sheet); exhibit != nullptr)
    return sheet.whole_image(box, exhibit->image, sheet.measures().corner);
  const std::optional<PlaceKind> kind = chosen_kind(sheet);
  const float side = std::round(std::min({box.width, box.height, 40 * sheet.measures().unit}));
  if (!kind || side < 1) return 0;
  draw_sign(sheet, *kind, {box.x, box.y, side, side});
  return side;
}

float draw_invitation(Sheet& sheet, const PixelBox& box, Letters title) {
  const Measures& m = sheet.measures();
  const std::string title_text = goal_title(sheet);
  if (title_text.empty()) return box.y;
  const std::optional<RouteSummary>& route_summary = sheet.request().route_summary;
  if (route_summary && route_summary->status != path::RouteStatus::Ok)
    return draw_refusal(sheet, refusal_of(sheet, *route_summary), box, title) + m.gap;
  TextStyle style = sheet.style(Letters::Lead);
  style.tabular = true;
  const float line = std::ceil(style.size * style.line_height);
  const TextPiece follow = sheet.fitted(
      sheet.style(Letters::Body),
      sheet.word(chosen_exhibit(sheet) != nullptr ? "follow" : "follow_to_place"), box.width);
  TextPiece name = sheet.fitted(sheet.style(title, 2), title_text, box.width);
  // Where there is little room, the name is said, and on one line.
  const bool tight = follow.height + name.height + m.unit + line > box.height;
  if (tight && name.height + m.unit + line > box.height)
    name = sheet.fitted(sheet.style(title), title_text, box.width);
  float y = box.y;
  if (!tight) y = sheet.piece(follow, box.x, y, box.width, Align::Start, sheet.theme().quiet_ink);
  y = sheet.piece(name, box.x, y, box.width, Align::Start, sheet.theme().ink) + m.unit;

  if (!route_summary)
    return sheet.text(Letters::Body, sheet.word("planning"), box.x, y, box.width,
                      sheet.theme().quiet_ink, 3) +
           m.gap;
  prepare_remaining(sheet, style, *route_summary, box.x, y, box.width);
  return y + line + m.gap;
}

namespace {

/// The museum's name, the welcome and what one can do here, as large as there is room for above
/// `bottom`; where there is hardly any, without the last.
void draw_greeting(Sheet& sheet, const PixelBox& content, float bottom) {
  const Measures& m = sheet.measures();
  struct Sizes {
    Letters title, welcome, lead;
  };
  constexpr std::array sizes{Sizes{Letters::Label, Letters::Welcome, Letters::Lead},
                             Sizes{Letters::Label, Letters::Title, Letters::Lead},
                             Sizes{Letters::Label, Letters::Title, Letters::Body},
                             Sizes{Letters::Body, Letters::Heading, Letters::Body},
                             Sizes{Letters::Body, Letters::Body, Letters::Body}};
  for (const Sizes& size : sizes) {
    const auto set = [&](Letters letters, std::string_view text, std::uint16_t lines) {
      return sheet.fitted(sheet.style(letters, lines), text, content.width);
    };
    const TextPiece title = set(size.title, sheet.local(sheet.museum().title), 2);
    const TextPiece welcome = set(size.welcome, sheet.word("welcome"), 2);
    const TextPiece lead = set(size.lead, sheet.local(sheet.museum().welcome), 4);
    const float top = content.y + title.height + m.gap;
    const float spare = bottom - top - welcome.height - m.gap - lead.height;
    const bool is_last = &size == &sizes.back();
    if (spare < 0 && !is_last) continue;
    sheet.piece(title, content.x, content.y, content.width, Align::Start, sheet.theme().quiet_ink);
    float y = top;
    if (is_landscape(sheet.request().shape))
      y = std::max(top, std::min(content.y + content.height * 0.2F, top + spare));
    y = sheet.piece(welcome, content.x, y, content.width, Align::Start, sheet.theme().ink) + m.gap;
    if (spare >= 0)
      sheet.piece(lead, content.x, y, content.width, Align::Start, sheet.theme().quiet_ink);
    return;
  }
}

}  // namespace

void lay_out_welcome(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const bool in_rows = sheet.museum().languages.size() > most_languages_beside;
  const float foot = in_rows ? draw_language_rows(sheet, content) : draw_foot(sheet, content, "");
  const float height = std::round(m.touch * 1.35F);
  const float width = std::round(std::min(content.width, 54 * m.unit));
  const PixelBox begin{content.x, foot - 2 * m.gap - height, width, height};
  draw_greeting(sheet, content, begin.y - m.gap);
  const std::int32_t resume = sheet.control("resume");
  if (resume < 0) return sheet.button(sheet.control("begin"), begin, Sheet::Emphasis::Strong);
  const float half = std::floor((content.width - m.gap) / 2);
  sheet.button(sheet.control("begin"), {begin.x, begin.y, half, height}, Sheet::Emphasis::Strong);
  sheet.button(resume, {content.right() - half, begin.y, half, height}, Sheet::Emphasis::Soft);
}

namespace {

/// An item of the list, and what collects it where that is an exhibit.
void draw_list_item(Sheet& sheet, std::int32_t control, const PixelBox& box) {
  const Measures& m = sheet.measures();
  const Action& action = sheet.view().controls[static_cast<std::size_t>(control)].action;
  if (action.kind == Action::Kind::Speak) return draw_language(sheet, control, box, Align::Start);
  const std::int32_t collect =
      action.kind == Action::Kind::Choose ? sheet.collect(action.argument) : -1;
  if (collect < 0) return draw_card(sheet, control, box);
  const float width = std::round(
      std::max(m.touch, std::min(12 * m.unit * sheet.request().shape.text_scale, box.width / 4)));
  const float gap = std::round(m.unit);
  draw_card(sheet, control, {box.x, box.y, box.width - width - gap, box.height});
  sheet.quiet_button(collect, {box.right() - width, box.y, width, box.height});
}

/// To begin the visitor's own tour, and to put more into it.
void draw_start(Sheet& sheet, const PixelBox& row) {
  const float half = std::floor((row.width - sheet.measures().gap) / 2);
  const std::array buttons{sheet.control("start-tour"), sheet.control("choose")};
  const TextStyle word = sheet.row_style(buttons, half);
  sheet.button(buttons[0], {row.x, row.y, half, row.height}, Sheet::Emphasis::Strong, word);
  sheet.button(buttons[1], {row.right() - half, row.y, half, row.height}, Sheet::Emphasis::Soft,
               word);
}

}  // namespace

void lay_out_choosing(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const ListShape list = list_shape(sheet.request().shape);
  const std::uint32_t per_page = list.columns * list.rows;
  const Listed lists = sheet.request().state.lists;
  const TextPiece heading =
      sheet.fitted(sheet.style(Letters::Heading), sheet.word(title_of(lists)), content.width);
  sheet.piece(heading, content.x, content.y, content.width, Align::Start, sheet.theme().ink);
  if (lists == Listed::OwnTour) {
    const float width = content.width - heading.width - 2 * m.gap;
    const TextPiece line =
        sheet.fitted(sheet.style(Letters::Small, 2), own_tour_line(sheet), width);
    sheet.piece(line, content.right() - width, content.y + (heading.height - line.height) / 2,
                width, Align::End, sheet.theme().quiet_ink);
  }

  const float column_gap = 2 * m.gap;
  const auto columns = static_cast<float>(list.columns);
  const float width = std::floor((content.width - (columns - 1) * column_gap) / columns);
  std::uint32_t shown = 0;
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i) {
    if (sheet.view().controls[i].role != Role::ListItem) continue;
    const std::uint32_t in_column = shown / list.rows;
    const auto column = static_cast<float>(in_column);
    const auto row = static_cast<float>(shown % list.rows);
    draw_list_item(sheet, static_cast<std::int32_t>(i),
                   {content.x + column * (width + column_gap),
                    content.y + list.heading_height + row * (list.row_height + list.row_gap), width,
                    list.row_height});
    ++shown;
  }

  const bool can_go_back = sheet.control("back") >= 0;
  const float foot = draw_foot(sheet, content, can_go_back ? "back" : "home");
  const float routes = foot - m.gap - m.touch;
  if (lists == Listed::OwnTour)
    draw_start(sheet, {content.x, routes, content.width, m.touch});
  else
    draw_routes(sheet, {content.x, routes, content.width, m.touch}, Along::Row);

  const std::uint32_t pages = page_count(sheet.museum(), sheet.request().state, per_page);
  if (pages == 1) return;
  const float y = routes - m.gap - m.touch;
  const float third = std::floor((content.width - 2 * m.gap) / 3);
  sheet.button(sheet.control("page:previous"), {content.x, y, third, m.touch},
               Sheet::Emphasis::Soft);
  sheet.button(sheet.control("page:next"), {content.right() - third, y, third, m.touch},
               Sheet::Emphasis::Soft);
  const std::uint32_t language = sheet.request().state.language;
  const std::uint32_t page = std::min(sheet.request().state.page, pages - 1);
  std::string text = filled_in(sheet.word("page_of"), "n",
                               number_in(sheet.museum(), language, static_cast<long>(page) + 1));
  text = filled_in(text, "total", number_in(sheet.museum(), language, static_cast<long>(pages)));
  const TextPiece count = sheet.fitted(sheet.style(Letters::Small), text, third);
  sheet.piece(count, content.x, y + (m.touch - count.height) / 2, content.width, Align::Centre,
              sheet.theme().quiet_ink);
}

void lay_out_walking(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const float foot = draw_foot(sheet, content, "home");
  const bool landscape = is_landscape(sheet.request().shape);
  const float buttons = foot - m.gap - m.touch;
  const float bottom = buttons - m.gap;

  PixelBox first = content, second = content;
  if (!landscape) std::tie(first, second) = halves(content, 2 * m.margin, 0.5F);
  const std::int32_t skip = sheet.control("skip"),
                     collect = sheet.collect(sheet.request().state.exhibit);
  const std::int32_t middle = skip < 0 ? collect : skip;
  const float shares = middle < 0 ? 2 : 3;
  const float share = std::floor((content.width - (shares - 1) * m.gap) / shares);
  const std::array row{sheet.control("stop"), middle, sheet.control("choose")};
  const TextStyle word = sheet.row_style(row, share);
  sheet.button(row[0], {content.x, buttons, share, m.touch}, Sheet::Emphasis::Strong, word);
  sheet.button(middle, {content.x + share + m.gap, buttons, share, m.touch},
               middle == skip ? Sheet::Emphasis::Soft : Sheet::Emphasis::Plain, word);
  sheet.button(row[2], {content.right() - share, buttons, share, m.touch}, Sheet::Emphasis::Soft,
               word);

  const float routes_height = 3 * m.touch + 2 * std::round(m.unit);
  const float routes_top = bottom - m.gap - routes_height;
  const TextPiece question =
      sheet.fitted(sheet.style(Letters::Body), sheet.word("route_title"), second.width);
  sheet.piece(question, second.x, routes_top - question.height - m.unit, second.width, Align::Start,
              sheet.theme().quiet_ink);
  draw_routes(sheet, {second.x, routes_top, second.width, routes_height}, Along::Column);

  const float end = landscape ? routes_top - question.height - 3 * m.gap : bottom;
  first.height = end - first.y;
  first = draw_tour_progress(sheet, first);
  // Where letters are large, the name makes way for the sentences.
  const bool is_tight =
      sheet.way() != nullptr && first.height < 44 * m.unit * sheet.request().shape.text_scale;
  float y = draw_invitation(sheet, first, is_tight ? Letters::Heading : Letters::Title);
  y = draw_sentences(sheet, {first.x, y, first.width, end - y});
  if (end - y > 12 * m.unit) draw_goal(sheet, {first.x, y, first.width, end - y});
}

void lay_out_arrived(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  const bool landscape = is_landscape(sheet.request().shape);
  const float foot = draw_foot(sheet, content, "home");
  const std::string title_text = goal_title(sheet);

  PixelBox first = content, second = content;
  if (!landscape) std::tie(first, second) = halves(content, 2 * m.margin, 0.42F);
  const float row = list_shape(sheet.request().shape).row_height;
  float bottom = foot - m.gap - m.touch;
  const std::int32_t collect = sheet.collect(sheet.request().state.exhibit);
  const float share = collect < 0 ? second.width : std::floor((second.width - m.gap) / 2);
  const std::array pair{collect, sheet.control("choose")};
  const TextStyle word = sheet.row_style(pair, share);
  sheet.button(pair[0], {second.x, bottom, share, m.touch}, Sheet::Emphasis::Plain, word);
  sheet.button(pair[1], {second.right() - share, bottom, share, m.touch}, Sheet::Emphasis::Soft,
               word);

  std::vector<std::int32_t> cards;
  for (std::size_t i = 0; i < sheet.view().controls.size(); ++i)
    if (sheet.view().controls[i].role == Role::ListItem)
      cards.push_back(static_cast<std::int32_t>(i));
  if (!cards.empty()) bottom -= m.unit;
  for (std::size_t i = cards.size(); i-- > 0;) {
    bottom -= row + std::round(m.unit);
    draw_card(sheet, cards[i], {second.x, bottom, second.width, row});
  }
  if (!cards.empty()) {
    const TextPiece next = sheet.fitted(
        sheet.style(Letters::Small),
        sheet.word(sheet.control("next") >= 0 ? "tour_next" : "next_title"), second.width);
    bottom -= next.height + std::round(m.unit / 2);
    sheet.piece(next, second.x, bottom, second.width, Align::Start, sheet.theme().quiet_ink);
  }
  bottom -= m.gap;
  second = draw_tour_progress(sheet, second);

  // The words come first; the picture takes what they leave. Where there is hardly any room, the
  // name is said, and smaller.
  const float text_width = second.width;
  TextStyle body_style = sheet.style(Letters::Body);
  const float line = body_style.size * body_style.line_height;
  const float least_picture = landscape ? 30 * m.unit : 0;
  TextPiece title;
  float room = 0;
  for (const auto& [letters, lines] :
       {std::pair{Letters::Title, 2}, std::pair{Letters::Heading, 2}, std::pair{Letters::Label, 1},
        std::pair{Letters::Small, 1}}) {
    title = sheet.fitted(sheet.style(letters, static_cast<std::uint16_t>(lines)), title_text,
                         text_width);
    room = bottom - second.y - title.height - m.gap;
    if (room >= line) break;
  }
  const float lines = std::floor((room - least_picture) / line);
  body_style.max_lines = static_cast<std::uint16_t>(std::clamp(lines, 1.0F, 40.0F));
  const TextPiece body =
      room < line ? TextPiece{} : sheet.fitted(body_style, goal_text(sheet), text_width);

  float y = second.y;
  if (landscape) {
    const float left = room - body.height - m.gap;
    if (left > 0) y += draw_goal(sheet, {content.x, y, content.width, left}) + m.gap;
  } else {
    draw_goal(sheet, {first.x, first.y, first.width, foot - m.gap - first.y});
  }
  y = sheet.piece(title, second.x, y, text_width, Align::Start, sheet.theme().ink) + m.unit;
  sheet.piece(body, second.x, y, text_width, Align::Start, sheet.theme().ink);
}

}  // namespace docent::interface
