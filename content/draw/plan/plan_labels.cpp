#include "content/draw/plan/plan_labels.h"

#include <algorithm>
#include <array>
#include <limits>

namespace docent::draw {
namespace {

struct LabelBox {
  Vec2 low{}, high{};
};

double overlap(const LabelBox& a, const LabelBox& b) {
  const Vec2 size = glm::min(a.high, b.high) - glm::max(a.low, b.low);
  return size.x > 0 && size.y > 0 ? size.x * size.y : 0;
}

double area_beyond(const LabelBox& box, Vec2 page) {
  const Vec2 size = box.high - box.low;
  return size.x * size.y - overlap(box, {{0, 0}, page});
}

/// The box of a label whose middle is displaced from its mark by whole steps.
LabelBox box_beside(const Label& label, Vec2 step, double letter) {
  constexpr double width_per_letter = 0.54;  // Of a sans in lower case, measured on Noto Sans.
  const Vec2 half{0.5 * width_per_letter * letter * static_cast<double>(label.words.size()),
                  0.6 * letter};
  const Vec2 middle = label.mark + step * (half + Vec2{0.9 * letter, 0.6 * letter});
  return {middle - half, middle + half};
}

}  // namespace

void place_labels(std::vector<Label>& labels, double letter, Vec2 page) {
  // Right of the mark reads best, then left, above, below, and the corners.
  constexpr std::array<Vec2, 8> steps = {Vec2{1, 0},  Vec2{-1, 0},  Vec2{0, -1}, Vec2{0, 1},
                                         Vec2{1, -1}, Vec2{-1, -1}, Vec2{1, 1},  Vec2{-1, 1}};
  const Vec2 around{0.5 * letter, 0.5 * letter};
  std::vector<LabelBox> taken;
  taken.reserve(2 * labels.size());
  for (const Label& label : labels) taken.push_back({label.mark - around, label.mark + around});
  for (Label& label : labels) {
    LabelBox best;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 step : steps) {
      const LabelBox box = box_beside(label, step, letter);
      double hidden = 10 * area_beyond(box, page);
      for (const LabelBox& other : taken) hidden += overlap(box, other);
      if (hidden < least) {
        least = hidden;
        best = box;
      }
    }
    label.baseline = {best.low.x, best.high.y - 0.3 * letter};
    taken.push_back(best);
  }
}

}  // namespace docent::draw
