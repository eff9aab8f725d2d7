#include "tests/bench/walk_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "content/draw/svg.h"

namespace docent::bench {
namespace {

constexpr double page_width = 1440, margin = 48, gap = 28;
constexpr double head_height = 104, title_height = 30, caption_height = 17, padding = 22;
constexpr std::string_view font = "font-family=\"Inter, Helvetica, Arial, sans-serif\"";

std::string text_style(double size, std::string_view colour, std::string_view weight = "400") {
  return fmt::format("font-size=\"{}\" fill=\"{}\" font-weight=\"{}\"", size, colour, weight);
}

struct Box {
  Vec2 low{1e300}, high{-1e300};

  void include(const std::vector<Vec2>& points) {
    for (const Vec2 p : points) low = glm::min(low, p), high = glm::max(high, p);
  }
  [[nodiscard]] Vec2 size() const { return high - low; }
  [[nodiscard]] Vec2 centre() const { return 0.5 * (low + high); }
};

/// Round the path's middle, so that pictures of one path lie alike.
Box box_of(const WalkPicture& picture) {
  Box path, all;
  path.include(picture.path);
  all.include(picture.path);
  for (const DrawnTrack& track : picture.tracks) all.include(track.points);
  const Vec2 centre = path.centre(), half = glm::max(centre - all.low, all.high - centre);
  return {centre - half, centre + half};
}

/// Where pictures are on the page, all of one size and scale.
struct Grid {
  std::size_t columns = 1;
  double scale = 1;        ///< Pixels a metre.
  Vec2 picture{}, cell{};  ///< Pixels; a cell is a picture with its title and captions.

  [[nodiscard]] Vec2 corner(std::size_t i) const {
    const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
    return {margin + column * (cell.x + gap), head_height + row * (cell.y + gap)};
  }
};

Grid lay_out(const std::vector<WalkPicture>& pictures, std::size_t columns) {
  Vec2 largest{1e-3};
  std::size_t captions = 0;
  for (const WalkPicture& picture : pictures) {
    largest = glm::max(largest, box_of(picture).size());
    captions = std::max(captions, picture.captions.size());
  }
  Grid grid{.columns = columns};
  grid.cell.x = (page_width - 2 * margin - gap * static_cast<double>(columns - 1)) /
                static_cast<double>(columns);
  grid.scale = (grid.cell.x - 2 * padding) / largest.x;
  grid.picture = {grid.cell.x, largest.y * grid.scale + 2 * padding};
  grid.cell.y = title_height + grid.picture.y + 8 + caption_height * static_cast<double>(captions);
  return grid;
}

void draw_line(draw::Svg& svg, const std::vector<Vec2>& pixels, std::string_view colour,
               double width) {
  if (pixels.empty()) return;
  draw::PathData data;
  data.move_to(pixels.front());
  for (const Vec2 p : pixels) data.line_to(p);
  svg.path(data, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
                             "stroke-linejoin=\"round\" stroke-linecap=\"round\"",
                             colour, width));
}

/// Of points closer than a third of a pixel the first: what is not seen is not stored.
std::vector<Vec2> thinned(const std::vector<Vec2>& pixels) {
  std::vector<Vec2> out;
  for (const Vec2 p : pixels)
    if (out.empty() || glm::distance(out.back(), p) > 0.33) out.push_back(p);
  return out;
}

void draw_picture(draw::Svg& svg, const WalkPicture& picture, const Grid& grid, Vec2 corner) {
  svg.text(corner + Vec2{0, 18}, picture.title, text_style(14.5, draw::ink::black, "600"));
  const Vec2 top = corner + Vec2{0, title_height};
  svg.rectangle(top, grid.picture, fmt::format("fill=\"{}\"", draw::ink::floor));
  const Vec2 middle = top + 0.5 * grid.picture, centre = box_of(picture).centre();
  const auto pixels = [&](const std::vector<Vec2>& points) {
    std::vector<Vec2> out;
    for (const Vec2 p : points)
      out.push_back(middle + grid.scale * Vec2{p.x - centre.x, centre.y - p.y});
    return thinned(out);
  };
  const std::vector<Vec2> path = pixels(picture.path);
  draw_line(svg, path, draw::mixed(draw::ink::stone, draw::ink::floor, 0.35), 7);
  for (const DrawnTrack& track : picture.tracks)
    draw_line(svg, pixels(track.points), track.colour, 1.5);
  svg.circle(path.front(), 4.5,
             fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"", draw::ink::floor,
                         draw::ink::black));
  svg.circle(path.back(), 4.5, fmt::format("fill=\"{}\"", draw::ink::black));
  for (std::size_t i = 0; i < picture.captions.size(); ++i)
    svg.text(top + Vec2{0, grid.picture.y + 18 + caption_height * static_cast<double>(i)},
             picture.captions[i], text_style(12, draw::ink::quiet));
}

void draw_legend(draw::Svg& svg, const std::vector<LegendEntry>& legend, const Grid& grid) {
  double x = margin;
  for (const LegendEntry& entry : legend) {
    draw_line(svg, {{x, 84}, {x + 26, 84}}, entry.colour, 2.4);
    svg.text({x + 34, 88}, entry.name, text_style(13, draw::ink::black));
    x += 66 + 7.2 * static_cast<double>(entry.name.size());
  }
  const double metres = grid.scale > 40 ? 1 : 5, bar = metres * grid.scale;
  const Vec2 from{page_width - margin - bar, 84};
  draw_line(svg, {from, from + Vec2{bar, 0}}, draw::ink::black, 2);
  svg.text(from - Vec2{40, -4}, fmt::format("{:g} m", metres), text_style(12, draw::ink::quiet));
}

}  // namespace

std::string draw_walks(const std::string& heading, const std::string& note,
                       const std::vector<LegendEntry>& legend,
                       const std::vector<WalkPicture>& pictures, std::size_t columns) {
  const Grid grid = lay_out(pictures, columns);
  const std::size_t rows = (pictures.size() + columns - 1) / columns;
  const double height = head_height + static_cast<double>(rows) * (grid.cell.y + gap) + margin / 2;
  draw::Svg svg(page_width, height);
  svg.rectangle({0, 0}, {page_width, height}, fmt::format("fill=\"{}\"", draw::ink::paper));
  svg.begin_group(font);
  svg.text({margin, 36}, heading, text_style(19, draw::ink::black, "700"));
  svg.text({margin, 58}, note, text_style(12.5, draw::ink::quiet));
  draw_legend(svg, legend, grid);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    draw_picture(svg, pictures[i], grid, grid.corner(i));
  svg.end_group();
  return svg.document();
}

}  // namespace docent::bench
