#include "content/object/cut_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "content/content_error.h"

namespace docent::object {
namespace {

/// Room about a picture, so that every outline is closed.
constexpr std::uint32_t border = 3;
constexpr std::uint8_t half = 128;
/// A hole or a piece of so much of the thing is no speck.
constexpr double large = 0.002;

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw content::ContentError(
      file, 0, 0, "busy-picture", what,
      "photograph it before a plain wall or sheet, with some of that on every side, or cut it out "
      "in a picture editor and save it as a PNG with a clear ground; or leave 'relief' out");
}

using Colour = std::array<int, 3>;

struct Field {
  explicit Field(const Pixels& picture) : picture_{picture} {}
  std::size_t width() const { return picture_.width; }
  std::size_t size() const { return std::size_t{picture_.width} * picture_.height; }
  Colour colour(std::size_t i) const {
    return {std::to_integer<int>(picture_.rgba[4 * i]),
            std::to_integer<int>(picture_.rgba[4 * i + 1]),
            std::to_integer<int>(picture_.rgba[4 * i + 2])};
  }
  std::uint8_t alpha(std::size_t i) const {
    return std::to_integer<std::uint8_t>(picture_.rgba[4 * i + 3]);
  }

 private:
  const Pixels& picture_;
};

/// The pixels left, right, above and below.
template <typename Visit>
void for_neighbours(std::size_t i, std::size_t width, std::size_t size, Visit visit) {
  if (i % width > 0) visit(i - 1);
  if (i % width + 1 < width) visit(i + 1);
  if (i >= width) visit(i - width);
  if (i + width < size) visit(i + width);
}

std::vector<std::size_t> edge_of(std::size_t width, std::size_t height) {
  std::vector<std::size_t> edge;
  for (std::size_t x = 0; x < width; ++x) {
    edge.push_back(x);
    edge.push_back((height - 1) * width + x);
  }
  for (std::size_t y = 0; y < height; ++y) {
    edge.push_back(y * width);
    edge.push_back(y * width + width - 1);
  }
  return edge;
}

double apart(const Colour& a, const Colour& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The colour in the middle of all, by channel.
Colour middle_of(const Field& field, const std::vector<std::size_t>& pixels) {
  Colour middle{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::vector<int> values;
    for (const std::size_t i : pixels) values.push_back(field.colour(i)[channel]);
    std::ranges::nth_element(values,
                             values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    middle[channel] = values[values.size() / 2];
  }
  return middle;
}

/// The pieces of what `is_in` holds: an index each, and how many pixels each has.
struct Pieces {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> of;
  std::vector<std::size_t> sizes;
};

template <typename IsIn>
Pieces pieces_of(std::size_t width, std::size_t size, IsIn is_in) {
  Pieces pieces{std::vector<std::size_t>(size, Pieces::none), {}};
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < size; ++start) {
    if (pieces.of[start] != Pieces::none || !is_in(start)) continue;
    const std::size_t piece = pieces.sizes.size();
    pieces.sizes.push_back(0);
    pieces.of[start] = piece;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      ++pieces.sizes[piece];
      for_neighbours(i, width, size, [&](std::size_t next) {
        if (pieces.of[next] != Pieces::none || !is_in(next)) return;
        pieces.of[next] = piece;
        open.push_back(next);
      });
    }
  }
  return pieces;
}

/// What is enclosed and of the very colour of the ground nearest to it is seen through, where there
/// is more of it than of a highlight.
void open_enclosed(const Field& field, std::vector<Colour>& beside,
                   std::vector<std::uint8_t>& cover) {
  constexpr double same = 22, least = 0.005;
  std::vector<bool> is_known(cover.size());
  std::queue<std::size_t> open;
  std::size_t thing = 0;
  for (std::size_t i = 0; i < cover.size(); ++i) {
    is_known[i] = cover[i] == 0;
    if (is_known[i])
      open.push(i);
    else
      ++thing;
  }
  while (!open.empty()) {
    const std::size_t i = open.front();
    open.pop();
    for_neighbours(i, field.width(), field.size(), [&](std::size_t next) {
      if (is_known[next]) return;
      is_known[next] = true;
      beside[next] = beside[i];
      open.push(next);
    });
  }
  const Pieces alike = pieces_of(field.width(), cover.size(), [&](std::size_t i) {
    return cover[i] != 0 && apart(field.colour(i), beside[i]) <= same;
  });
  for (std::size_t i = 0; i < cover.size(); ++i)
    if (alike.of[i] != Pieces::none &&
        static_cast<double>(alike.sizes[alike.of[i]]) > least * static_cast<double>(thing))
      cover[i] = 0;
}

/// Of each pixel: 0 as the ground, 255 as far from it as a thing is.
std::vector<std::uint8_t> cover_on_plain(const Field& field, std::size_t height,
                                         const std::string& file) {
  // Of 441 between black and white. Shades of one wall are within the first, grain and JPEG
  // within the second of their neighbours.
  constexpr double ground_range = 60, alike = 26;
  constexpr double most_other = 0.03;
  const std::vector<std::size_t> edge = edge_of(field.width(), height);
  const Colour ground = middle_of(field, edge);
  const auto other = std::ranges::count_if(
      edge, [&](std::size_t i) { return apart(field.colour(i), ground) > ground_range; });
  if (static_cast<double>(other) > most_other * static_cast<double>(edge.size()))
    refuse(file,
           fmt::format("its ground is busy: {:.0f} % of its edge is of another colour than "
                       "the rest, so that nothing tells what the thing is",
                       100.0 * static_cast<double>(other) / static_cast<double>(edge.size())));
  std::vector<std::uint8_t> cover(field.size(), 255);
  // From the edges inwards, over what is alike: each pixel knows the ground that it is beside.
  std::vector<Colour> beside(field.size());
  std::queue<std::size_t> open;
  for (const std::size_t i : edge)
    if (cover[i] != 0 && apart(field.colour(i), ground) <= ground_range) {
      cover[i] = 0;
      beside[i] = field.colour(i);
      open.push(i);
    }
  while (!open.empty()) {
    const std::size_t i = open.front();
    open.pop();
    for_neighbours(i, field.width(), field.size(), [&](std::size_t next) {
      const Colour colour = field.colour(next);
      if (cover[next] == 0 || apart(colour, ground) > ground_range ||
          apart(colour, beside[i]) > alike)
        return;
      cover[next] = 0;
      // Follows a shade, and does not walk up an edge.
      for (std::size_t c = 0; c < 3; ++c) beside[next][c] = (7 * beside[i][c] + colour[c] + 4) / 8;
      open.push(next);
    });
  }
  open_enclosed(field, beside, cover);
  return cover;
}

/// Keeps the largest piece; returns how many others were large enough to be missed.
std::size_t keep_largest(std::size_t width, std::vector<std::uint8_t>& cover) {
  const Pieces pieces =
      pieces_of(width, cover.size(), [&](std::size_t i) { return cover[i] >= half; });
  if (pieces.sizes.empty()) return 0;
  const auto largest =
      static_cast<std::size_t>(std::ranges::max_element(pieces.sizes) - pieces.sizes.begin());
  const double least = large * static_cast<double>(pieces.sizes[largest]);
  for (std::size_t i = 0; i < cover.size(); ++i) {
    // A soft rim belongs to the piece beside it.
    bool is_near = pieces.of[i] == largest;
    if (pieces.of[i] == Pieces::none)
      for_neighbours(i, width, cover.size(),
                     [&](std::size_t next) { is_near |= pieces.of[next] == largest; });
    if (!is_near) cover[i] = 0;
  }
  return static_cast<std::size_t>(std::ranges::count_if(
             pieces.sizes, [&](std::size_t size) { return static_cast<double>(size) > least; })) -
         1;
}

void fill_small_holes(std::size_t width, std::vector<std::uint8_t>& cover) {
  const auto thing =
      static_cast<double>(std::ranges::count_if(cover, [](std::uint8_t c) { return c >= half; }));
  const Pieces holes =
      pieces_of(width, cover.size(), [&](std::size_t i) { return cover[i] < half; });
  for (std::size_t i = 0; i < cover.size(); ++i)
    if (holes.of[i] != Pieces::none && holes.of[i] != holes.of[0] &&
        static_cast<double>(holes.sizes[holes.of[i]]) < large * thing)
      cover[i] = 255;
}

/// With nothing about it.
Pixels with_border(const Pixels& picture) {
  Pixels made{
      .width = picture.width + 2 * border, .height = picture.height + 2 * border, .rgba = {}};
  made.rgba.resize(std::size_t{4} * made.width * made.height);
  for (std::uint32_t y = 0; y < picture.height; ++y)
    std::copy_n(picture.rgba.begin() + std::ptrdiff_t{4} * y * picture.width,
                std::ptrdiff_t{4} * picture.width,
                made.rgba.begin() + std::ptrdiff_t{4} * ((y + border) * made.width + border));
  return made;
}

/// Those of the pixels that have no neighbour that is not among them.
std::vector<bool> eroded(const std::vector<bool>& pixels, std::size_t width) {
  std::vector<bool> inner = pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for_neighbours(i, width, pixels.size(), [&](std::size_t next) {
      if (!pixels[next]) inner[i] = false;
    });
  return inner;
}

/// The pixels and those that are so many steps from them.
std::vector<bool> grown(std::vector<bool> pixels, std::size_t width, int steps) {
  for (int step = 0; step < steps; ++step) {
    const std::vector<bool> before = pixels;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      for_neighbours(i, width, pixels.size(), [&](std::size_t next) {
        if (before[next]) pixels[i] = true;
      });
  }
  return pixels;
}

/// The pixels whose colour is the thing's own: those at the outline are mixed with the ground, or
/// of the line that it is drawn with. What is thinner than that keeps those in its middle.
std::vector<bool> pure_pixels(const std::vector<std::uint8_t>& cover, std::size_t width) {
  constexpr int mixed = 3;
  std::vector<std::vector<bool>> within(1, std::vector<bool>(cover.size()));
  for (std::size_t i = 0; i < cover.size(); ++i) within[0][i] = cover[i] >= half;
  for (int ring = 0; ring < mixed; ++ring) within.push_back(eroded(within.back(), width));
  std::vector<bool> pure = within.back();
  for (int ring = mixed - 1; ring >= 0; --ring) {
    const std::vector<bool> near = grown(pure, width, mixed + 1);
    const std::vector<bool>& candidates = within[static_cast<std::size_t>(ring)];
    for (std::size_t i = 0; i < cover.size(); ++i)
      if (candidates[i] && !near[i]) pure[i] = true;
  }
  return pure;
}

/// The colours at the outline go on beyond it, so that nothing of the ground shows there.
void spread_colours(const std::vector<std::uint8_t>& cover, Pixels& picture) {
  std::vector<bool> is_known = pure_pixels(cover, picture.width);
  std::queue<std::size_t> open;
  for (std::size_t i = 0; i < cover.size(); ++i)
    if (is_known[i]) open.push(i);
  while (!open.empty()) {
    const std::size_t i = open.front();
    open.pop();
    for_neighbours(i, picture.width, cover.size(), [&](std::size_t next) {
      if (is_known[next]) return;
      is_known[next] = true;
      std::copy_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                  picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * next));
      open.push(next);
    });
  }
}

/// Only as much of both as the thing and its border take.
void crop(CutOut& cut) {
  const std::size_t width = cut.mask.width;
  std::uint32_t left = cut.mask.width, right = 0, top = cut.mask.height, bottom = 0;
  for (std::size_t i = 0; i < cut.mask.cover.size(); ++i) {
    if (cut.mask.cover[i] == 0) continue;
    const auto x = static_cast<std::uint32_t>(i % width), y = static_cast<std::uint32_t>(i / width);
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
  left -= std::min(left, border);
  top -= std::min(top, border);
  right = std::min(right + border, cut.mask.width - 1);
  bottom = std::min(bottom + border, cut.mask.height - 1);
  CutOut part{{right - left + 1, bottom - top + 1, {}}, {}, cut.other_pieces};
  part.picture.width = part.mask.width;
  part.picture.height = part.mask.height;
  for (std::uint32_t y = top; y <= bottom; ++y) {
    const auto row = static_cast<std::ptrdiff_t>(y * width + left);
    part.mask.cover.insert(part.mask.cover.end(), cut.mask.cover.begin() + row,
                           cut.mask.cover.begin() + row + part.mask.width);
    part.picture.rgba.insert(part.picture.rgba.end(), cut.picture.rgba.begin() + 4 * row,
                             cut.picture.rgba.begin() + 4 * (row + part.mask.width));
  }
  cut = std::move(part);
}

}  // namespace

CutOut cut_out(const Pixels& picture, const std::string& file) {
  constexpr std::uint32_t least_side = 16;
  if (std::min(picture.width, picture.height) < least_side)
    refuse(file, fmt::format("it has {} x {} pixels, too few for an outline", picture.width,
                             picture.height));
  const Field given(picture);
  const std::vector<std::size_t> edge = edge_of(picture.width, picture.height);
  // A photograph that was cut out is clear in most of its edges, or it has no clear pixel.
  std::size_t clear = 0;
  for (std::size_t i = 0; i < given.size(); ++i) clear += given.alpha(i) < half ? 1 : 0;
  constexpr double some = 0.005;
  const bool has_clear_ground =
      static_cast<double>(clear) > some * static_cast<double>(given.size());
  std::vector<std::uint8_t> plain;
  if (!has_clear_ground) plain = cover_on_plain(given, picture.height, file);

  CutOut cut{
      {picture.width + 2 * border, picture.height + 2 * border, {}}, with_border(picture), 0};
  cut.mask.cover.assign(std::size_t{cut.mask.width} * cut.mask.height, 0);
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::size_t i = std::size_t{y} * picture.width + x;
      cut.mask.cover[std::size_t{y + border} * cut.mask.width + x + border] =
          has_clear_ground ? given.alpha(i) : plain[i];
    }
  cut.other_pieces = keep_largest(cut.mask.width, cut.mask.cover);
  fill_small_holes(cut.mask.width, cut.mask.cover);
  const auto shown = static_cast<double>(
      std::ranges::count_if(cut.mask.cover, [](std::uint8_t c) { return c >= half; }));
  if (shown < 0.001 * static_cast<double>(given.size()))
    refuse(file, "it shows nothing but its ground");
  spread_colours(cut.mask.cover, cut.picture);
  for (std::size_t i = 3; i < cut.picture.rgba.size(); i += 4) cut.picture.rgba[i] = std::byte{255};
  crop(cut);
  return cut;
}

}  // namespace docent::object
