#include "content/object/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"

namespace docent::object {
namespace {

using Ring = std::vector<Vec2>;

/// How much is covered about the middle of each pixel, less a half; rows from below.
class Cover {
 public:
  explicit Cover(const Mask& mask) : width_{mask.width}, height_{mask.height} {
    constexpr std::array<float, 3> weight{0.25F, 0.5F, 0.25F};
    const auto at = [&](std::int64_t x, std::int64_t y) {
      const bool is_in = x >= 0 && y >= 0 && x < static_cast<std::int64_t>(width_) &&
                         y < static_cast<std::int64_t>(height_);
      return is_in ? static_cast<float>(
                         mask.cover[(height_ - 1 - static_cast<std::size_t>(y)) * width_ +
                                    static_cast<std::size_t>(x)]) /
                         255
                   : 0.0F;
    };
    for (std::int64_t y = 0; y < static_cast<std::int64_t>(height_); ++y)
      for (std::int64_t x = 0; x < static_cast<std::int64_t>(width_); ++x) {
        float sum = -0.5F;
        for (std::int64_t dy = -1; dy <= 1; ++dy)
          for (std::int64_t dx = -1; dx <= 1; ++dx)
            sum += weight[static_cast<std::size_t>(dx + 1)] *
                   weight[static_cast<std::size_t>(dy + 1)] * at(x + dx, y + dy);
        // Nothing lies on the line itself.
        value_.push_back(sum == 0 ? 1e-6F : sum);
      }
  }
  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  float at(std::size_t x, std::size_t y) const { return value_[y * width_ + x]; }

 private:
  std::size_t width_, height_;
  std::vector<float> value_;
};

/// Lorensen and Cline's cubes, in the plane: the lines through a square between four pixels, with
/// what is covered on their left. Edges of a square: below, right, above, left.
class Squares {
 public:
  explicit Squares(const Cover& cover)
      : cover_(cover), next_(2 * cover.width() * cover.height(), none) {
    for (std::size_t y = 0; y + 1 < cover.height(); ++y)
      for (std::size_t x = 0; x + 1 < cover.width(); ++x) add_square(x, y);
  }

  std::vector<Ring> rings() {
    std::vector<Ring> rings;
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] == none) continue;
      Ring& ring = rings.emplace_back();
      for (std::size_t at = start; next_[at] != none;) {
        ring.push_back(place_on(at));
        at = std::exchange(next_[at], none);
      }
    }
    return rings;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void add_square(std::size_t x, std::size_t y) {
    const std::array<float, 4> corner{cover_.at(x, y), cover_.at(x + 1, y), cover_.at(x + 1, y + 1),
                                      cover_.at(x, y + 1)};
    const std::size_t width = cover_.width(), here = 2 * (y * width + x);
    const std::array<std::size_t, 4> edge{here, here + 3, here + 2 * width, here + 1};
    const bool is_joined = corner[0] + corner[1] + corner[2] + corner[3] > 0;
    for (std::size_t k = 0; k < 4; ++k) {
      // Counter-clockwise, a line ends where what is covered begins.
      if (corner[k] > 0 || corner[(k + 1) % 4] <= 0) continue;
      // It comes from where that ends: of two such edges, by what is in the middle.
      const std::size_t before = (k + 3) % 4, after = (k + 1) % 4;
      const bool from_before = (corner[before] > 0) != (corner[k] > 0);
      const bool from_after = (corner[after] > 0) != (corner[(after + 1) % 4] > 0);
      const std::size_t from = from_before && from_after ? (is_joined ? before : after)
                               : from_before             ? before
                               : from_after              ? after
                                                         : (k + 2) % 4;
      next_[edge[from]] = edge[k];
    }
  }

  Vec2 place_on(std::size_t edge) const {
    const std::size_t x = edge / 2 % cover_.width(), y = edge / 2 / cover_.width();
    const bool is_upright = edge % 2 == 1;
    const double from = cover_.at(x, y),
                 to = is_upright ? cover_.at(x, y + 1) : cover_.at(x + 1, y);
    const double share = from / (from - to);
    return Vec2{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5} +
           (is_upright ? Vec2{0, share} : Vec2{share, 0});
  }

  const Cover& cover_;
  std::vector<std::size_t> next_;  ///< By edge: where the line from it ends.
};

/// Douglas and Peucker between two corners that stay.
void thin(std::span<const Vec2> line, double tolerance, Ring& kept) {
  double farthest = tolerance;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (const double off = distance_to_segment(line[i], line.front(), line.back());
        off > farthest) {
      farthest = off;
      at = i;
    }
  if (at == 0) return;
  thin(line.first(at + 1), tolerance, kept);
  kept.push_back(line[at]);
  thin(line.subspan(at), tolerance, kept);
}

Ring thinned(Ring ring, double tolerance) {
  const auto lowest = std::ranges::min_element(
      ring, [](Vec2 a, Vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  std::ranges::rotate(ring, lowest);
  const auto far = static_cast<std::size_t>(
      std::ranges::max_element(ring, {},
                               [&](Vec2 p) { return dot(p - ring.front(), p - ring.front()); }) -
      ring.begin());
  ring.push_back(ring.front());
  const std::span<const Vec2> line(ring);
  Ring kept{ring.front()};
  thin(line.first(far + 1), tolerance, kept);
  kept.push_back(ring[far]);
  thin(line.subspan(far), tolerance, kept);
  return kept;
}

bool cross_anywhere(const std::vector<Ring>& rings) {
  struct Side {
    Vec2 a, b;
    std::size_t ring, index;
  };
  std::vector<Side> sides;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i)
      sides.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()], r, i});
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const Side& s = sides[i];
      const Side& t = sides[j];
      if (std::max(s.a.x, s.b.x) < std::min(t.a.x, t.b.x) ||
          std::max(t.a.x, t.b.x) < std::min(s.a.x, s.b.x))
        continue;
      const std::size_t apart = t.index - s.index, count = rings[s.ring].size();
      if (s.ring == t.ring && (apart == 1 || apart + 1 == count)) continue;
      if (segment_distance_squared(s.a, s.b, t.a, t.b) < 1e-8) return true;
    }
  return false;
}

}  // namespace

std::vector<std::vector<Vec2>> trace(const Mask& mask, double tolerance) {
  const std::vector<Ring> fine = Squares(Cover(mask)).rings();
  std::vector<Ring> rings;
  for (;; tolerance /= 2) {
    rings.clear();
    for (const Ring& ring : fine) {
      Ring kept = thinned(ring, tolerance);
      constexpr double speck = 2;  // square pixels
      if (kept.size() >= 3 && std::abs(signed_area(kept)) > speck) rings.push_back(std::move(kept));
    }
    constexpr double none_at_all = 0.01;
    if (tolerance < none_at_all || !cross_anywhere(rings)) break;
  }
  std::ranges::stable_sort(
      rings, [](const Ring& a, const Ring& b) { return signed_area(a) > signed_area(b); });
  // Smoothed, one piece may have become several: the others are specks.
  const auto holes = std::ranges::find_if(rings, [](const Ring& r) { return signed_area(r) < 0; });
  if (holes - rings.begin() > 1) rings.erase(rings.begin() + 1, holes);
  return rings;
}

}  // namespace docent::object
