/// The welcome: what can be touched there, and what stands on its panel.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "runtime/interface/face.h"
#include "runtime/interface/logo.h"
#include "runtime/interface/parts.h"
#include "runtime/interface/pictures.h"

namespace docent::interface {
namespace {

constexpr std::size_t most_highlights = 3;
/// Where a list has room for fewer rows, the panel has none for more than a greeting.
constexpr std::uint32_t fewest_rows = 5;

/// The exhibits that weigh most, of those of which there is a picture; in the museum's order where
/// they weigh the same.
std::vector<std::uint32_t> highlights_of(const Museum& museum) {
  std::vector<std::uint32_t> all(museum.exhibits.size());
  std::iota(all.begin(), all.end(), 0U);
  std::erase_if(all, [&](std::uint32_t i) {
    return museum.exhibits[i].weight <= 0 || !is_pictured(museum, i);
  });
  std::ranges::stable_sort(all, std::greater{},
                           [&](std::uint32_t i) { return museum.exhibits[i].weight; });
  all.resize(std::min(all.size(), most_highlights));
  return all;
}

/// Exhibits beside each other: each a square picture, cut where there is no room for all of it, and
/// its name below.
class Tiles {
 public:
  Tiles(Sheet& sheet, std::vector<std::int32_t> controls)
      : sheet_(sheet), controls_(std::move(controls)), style_(sheet.style(Letters::Small)) {
    style_.line_height = style_.line_height > 1.5F ? 1.4F : 1.2F;
  }

  /// Of each.
  float width(float all) const {
    const auto count = static_cast<float>(controls_.size());
    return std::floor((all - (most_highlights - 1) * gap()) /
                      std::max(count, static_cast<float>(most_highlights)));
  }
  float least(float all) const {
    constexpr float least_share = 0.6F;  // of a square
    return std::max(sheet_.measures().touch, std::round(least_share * width(all))) + names(all);
  }
  float most(float all) const { return width(all) + names(all); }

  void draw(const PixelBox& box) const {
    const float wide = width(box.width), picture = box.height - names(box.width);
    PixelBox tile{box.x, box.y, wide, box.height};
    for (const std::int32_t control : controls_) {
      sheet_.place(control, tile);
      const PixelBox image{tile.x, tile.y, wide, std::floor(picture)};
      sheet_.fill(image, sheet_.theme().plaster, sheet_.measures().corner, control);
      sheet_.image(image, sheet_.museum().exhibits[sheet_.at(control).action.argument].image,
                   sheet_.measures().corner, control);
      sheet_.text_of(control, style_, sheet_.label_of(control), tile.x,
                     tile.y + picture + sheet_.measures().unit, wide, sheet_.theme().ink);
      tile.x += wide + gap();
    }
  }

 private:
  float gap() const { return sheet_.measures().gap; }
  /// How high the highest of the names is, with the gap above it.
  float names(float all) const {
    float height = 0;
    for (const std::int32_t control : controls_)
      height = std::max(height, sheet_.height_of(style_, sheet_.label_of(control), width(all)));
    return std::ceil(height + sheet_.measures().unit);
  }

  Sheet& sheet_;
  std::vector<std::int32_t> controls_;
  TextStyle style_;
};

Block tiles_block(Sheet& sheet, std::vector<std::int32_t> controls, float gap) {
  const auto tiles = std::make_shared<const Tiles>(sheet, std::move(controls));
  return {.height = [tiles](float width) { return tiles->least(width); },
          .draw = [tiles](const PixelBox& box) { tiles->draw(box); },
          .gap = gap,
          .most = [tiles](float width) { return tiles->most(width); }};
}

Block question_block(Sheet& sheet, std::string_view key) {
  return text_block(sheet, sheet.style(Letters::Small), std::string(sheet.word(key)),
                    sheet.theme().quiet_ink, sheet.measures().unit);
}

/// What is most worth seeing.
std::vector<Block> highlight_blocks(Sheet& sheet) {
  std::vector<std::int32_t> tiles = list_items(sheet);
  if (tiles.empty()) return {};
  return {question_block(sheet, "highlights"),
          tiles_block(sheet, std::move(tiles), 2 * sheet.measures().gap)};
}

/// How much time one has: beside each other, or one below the other.
std::vector<Block> time_blocks(Sheet& sheet, Along along) {
  std::vector<RowButton> times;
  for (std::size_t i = 0; i < sheet.controls().size(); ++i)
    if (sheet.controls()[i].action.kind == Action::Kind::FollowTour)
      times.push_back({static_cast<std::int32_t>(i), Sheet::Emphasis::Light});
  if (times.empty()) return {};
  std::vector<Block> blocks{question_block(sheet, "times")};
  if (along == Along::Row)
    blocks.push_back(buttons_block(sheet, std::move(times), 0));
  else
    for (const RowButton& one : times)
      blocks.push_back(buttons_block(sheet, {one}, sheet.measures().gap));
  return blocks;
}

/// Two columns of blocks, the left one so wide.
Block columns_block(Sheet& sheet, std::vector<Block> left, std::vector<Block> right, float share) {
  struct Columns {
    std::vector<Block> left, right;
    float share, between;

    float width(float all) const { return std::floor(share * (all - between)); }
    float height(float all) const {
      const float wide = width(all);
      return std::max(height_of(left, wide), height_of(right, all - between - wide));
    }
    static float most_of(const std::vector<Block>& blocks, float width) {
      float more = 0;
      for (const Block& block : blocks)
        if (block.most) more += std::max(0.0F, block.most(width) - block.height(width));
      return height_of(blocks, width) + more;
    }
  };
  const auto columns = std::make_shared<const Columns>(std::move(left), std::move(right), share,
                                                       2 * sheet.measures().gap);
  return {.height = [columns](float width) { return columns->height(width); },
          .draw =
              [&sheet, columns](const PixelBox& box) {
                const float wide = columns->width(box.width), other = box.width - wide;
                lay_out_column(sheet, {box.x, box.y, wide, box.height}, columns->left, {});
                lay_out_column(sheet,
                               {box.right() - other + columns->between, box.y,
                                other - columns->between, box.height},
                               columns->right, {});
              },
          .gap = 0,
          .most =
              [columns](float width) {
                return std::max(columns->height(width),
                                Columns::most_of(columns->left, columns->width(width)));
              }};
}

/// Below each other, or, on an upright screen, beside each other where letters leave room for it.
std::vector<Block> offer_blocks(Sheet& sheet, float width) {
  constexpr float share = 0.64F, least_column = 30;  // units
  const float unit = sheet.measures().unit * sheet.request().shape.text_scale;
  std::vector<Block> highlights = highlight_blocks(sheet);
  const bool is_beside = !is_landscape(sheet.request().shape) && !highlights.empty() &&
                         (1 - share) * width > least_column * unit;
  std::vector<Block> times = time_blocks(sheet, is_beside ? Along::Column : Along::Row);
  if (is_beside && !times.empty())
    return {columns_block(sheet, std::move(highlights), std::move(times), share)};
  std::ranges::move(times, std::back_inserter(highlights));
  return highlights;
}

/// Leaves a fifth of the height free where it can be.
Block free_block(float most) {
  return {.height = [](float) { return 0.0F; },
          .draw = [](const PixelBox&) {},
          .most = [most](float) { return most; }};
}

/// What it draws is also seen while nobody is there.
Block greeting(Sheet& sheet, Block block) {
  block.draw = [&sheet, draw = std::move(block.draw)](const PixelBox& box) {
    const std::size_t first = sheet.view().elements.size();
    draw(box);
    for (Element& element : std::span(sheet.view().elements).subspan(first)) element.greets = true;
  };
  return block;
}

std::vector<Block> greeting_blocks(Sheet& sheet) {
  const Measures& m = sheet.measures();
  const scene::Theme& theme = sheet.theme();
  const Museum& museum = sheet.museum();
  return {
      text_block(sheet, sheet.style(Letters::Label), std::string(sheet.local(museum.title)),
                 theme.quiet_ink, m.gap),
      heading_block(sheet, Letters::Welcome, std::string(sheet.word("welcome")), theme.ink, m.gap),
      text_block(sheet, sheet.style(Letters::Lead), std::string(sheet.local(museum.welcome)),
                 theme.quiet_ink, 2 * m.gap)};
}

/// The museum's sign, and its name beside it.
Block beside_logo(const Sheet& sheet, const Logo& logo, const Block& name) {
  const float between = 2 * sheet.measures().gap;
  const auto room = [logo, between](float width) { return width - logo.width(width) - between; };
  return {.height =
              [logo, name, room](float width) {
                return std::max(logo.block.height(width), name.height(room(width)));
              },
          .draw =
              [logo, name, room](const PixelBox& box) {
                const float wide = room(box.width);
                const auto middle = [&](float height) {
                  return std::round(box.y + (box.height - height) / 2);
                };
                const float sign = logo.block.height(box.width), text = name.height(wide);
                logo.block.draw({box.x, middle(sign), box.width, sign});
                name.draw({box.right() - wide, middle(text), wide, text});
              },
          .gap = name.gap};
}

/// Above all, or beside the museum's name where there is more to see; nowhere, rather than that one
/// has to scroll for what is said.
void add_logo(Sheet& sheet, const PixelBox& content, const std::vector<Block>& foot,
              bool has_offers, std::vector<Block>& body) {
  constexpr LogoSize small{.units_high = 8, .units_wide = 26};
  const auto logo = has_offers ? logo_of(sheet, small) : logo_of(sheet);
  if (!logo) return;
  std::vector<Block> with = body;
  if (has_offers)
    with.front() = beside_logo(sheet, *logo, body.front());
  else
    with.insert(with.begin(), logo->block);
  const float all =
      height_of(with, content.width) + height_of(foot, content.width) + sheet.measures().gap;
  if (all <= content.height) body = std::move(with);
}

}  // namespace

void add_offers(const ControlRequest& request, std::vector<Control>& out) {
  const auto& [museum, state, per_page] = request;
  if (per_page < fewest_rows) return;
  for (const std::uint32_t exhibit : highlights_of(museum))
    out.push_back(exhibit_control(museum, exhibit, Role::ListItem, state));
  for (auto tour = tours_of_staff(museum); tour < museum.tours.size(); ++tour)
    out.push_back(tour_control(museum, tour, Role::Button, state));
}

void lay_out_welcome(Sheet& sheet, const PixelBox& content) {
  const Measures& m = sheet.measures();
  std::vector<Block> body = greeting_blocks(sheet), offers = offer_blocks(sheet, content.width);
  std::vector<Block> foot{buttons_block(sheet,
                                        {{sheet.control("begin"), Sheet::Emphasis::Strong},
                                         {sheet.control("resume"), Sheet::Emphasis::Soft}},
                                        2 * m.gap, std::round(m.touch * 1.35F)),
                          languages_block(sheet, 0)};
  const std::size_t count = offers.size();
  const bool has_offers = count > 0;
  std::ranges::move(offers, std::back_inserter(body));
  add_logo(sheet, content, foot, has_offers, body);
  const std::size_t greetings = body.size() - count;
  for (Block& block : std::span(body).first(greetings)) block = greeting(sheet, std::move(block));
  if (is_landscape(sheet.request().shape) && !has_offers)
    body.insert(body.begin(), free_block(0.2F * content.height));
  lay_out_column(sheet, content, std::move(body), std::move(foot));
}

}  // namespace docent::interface
