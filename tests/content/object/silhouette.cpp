#include "tests/content/object/silhouette.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace docent::test {
namespace {

/// Samples along each side of a pixel.
constexpr int fine = 4;
constexpr int width = 1920 * fine, height = 1080 * fine, margin = 8 * fine;
/// Pixels at which an error is as bad as any.
constexpr int worst = 6;

struct View {
  float cosine = 1, sine = 0, tilt_cosine = 1, tilt_sine = 0, scale = 1;
  Vec3 middle{0};

  glm::vec2 seen(Vec3 p) const {
    const Vec3 d = p - middle;
    const float x = cosine * d.x + sine * d.z, z = -sine * d.x + cosine * d.z;
    const float y = tilt_cosine * d.y - tilt_sine * z;
    return {width / 2.0F + scale * x, height / 2.0F - scale * y};
  }
};

/// Pixels that are covered: those whose centre is, and those that a thin edge goes through.
std::vector<bool> mask_of(const object::Shape& shape, const View& view) {
  std::vector<bool> mask(std::size_t{width} * height);
  const auto set = [&](float x, float y) {
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    if (column >= 0 && row >= 0 && column < width && row < height)
      mask[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] = true;
  };
  const auto line = [&](glm::vec2 a, glm::vec2 b) {
    const float steps = std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)));
    for (float i = 0; i <= steps; ++i) {
      const float t = steps > 0 ? i / steps : 0;
      set(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
    }
  };
  for (std::size_t k = 0; k + 2 < shape.indices.size(); k += 3) {
    const glm::vec2 a = view.seen(shape.vertices[shape.indices[k]].position),
                    b = view.seen(shape.vertices[shape.indices[k + 1]].position),
                    c = view.seen(shape.vertices[shape.indices[k + 2]].position);
    line(a, b);
    line(b, c);
    line(c, a);
    const auto edge = [](glm::vec2 p, glm::vec2 q, float x, float y) {
      return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
    };
    const float area = edge(a, b, c.x, c.y);
    if (area == 0) continue;
    const int left = std::max(0, static_cast<int>(std::min({a.x, b.x, c.x})));
    const int right = std::min(width - 1, static_cast<int>(std::max({a.x, b.x, c.x})));
    const int top = std::max(0, static_cast<int>(std::min({a.y, b.y, c.y})));
    const int bottom = std::min(height - 1, static_cast<int>(std::max({a.y, b.y, c.y})));
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
        const float u = edge(b, c, px, py) / area, v = edge(c, a, px, py) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) set(px, py);
      }
  }
  return mask;
}

/// How far the one that is furthest from all of another lies from it, in samples.
float furthest(const std::vector<bool>& mask, const std::vector<bool>& from) {
  int most = 0;  // squared
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i] || from[i]) continue;
    const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    int least = worst * fine * worst * fine;
    for (int reach = 1; reach * reach < least; ++reach)
      for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; dx += std::abs(dy) == reach ? 1 : 2 * reach) {
          const int column = x + dx, row = y + dy;
          if (column < 0 || row < 0 || column >= width || row >= height) continue;
          if (from[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)])
            least = std::min(least, dx * dx + dy * dy);
        }
    most = std::max(most, least);
  }
  return std::sqrt(static_cast<float>(most));
}

}  // namespace

float silhouette_error(const object::Shape& shape, const object::Shape& other, int views) {
  const object::Box box = object::box_of(shape);
  const Vec3 size = box.size();
  const float across = std::hypot(size.x, size.z), tall = std::max(size.y, 1e-6F);
  const float scale = std::min((height - 2 * margin) / std::hypot(tall, 0.3F * across),
                               (width - 2 * margin) / std::max(across, 1e-6F));
  float most = 0;
  for (int i = 0; i < views; ++i) {
    const float turn =
        2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(views);
    const float tilt = i % 2 == 0 ? 0.0F : 0.3F;
    const View view{.cosine = std::cos(turn),
                    .sine = std::sin(turn),
                    .tilt_cosine = std::cos(tilt),
                    .tilt_sine = std::sin(tilt),
                    .scale = scale,
                    .middle = (box.low + box.high) / 2.0F};
    const std::vector<bool> one = mask_of(shape, view), two = mask_of(other, view);
    most = std::max({most, furthest(one, two), furthest(two, one)});
  }
  return most / fine;
}

}  // namespace docent::test
