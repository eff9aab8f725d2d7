#pragma once

#include <string>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::draw {

/// A word beside a mark. Pixels, y down.
struct Label {
  std::string words;
  Vec2 mark{};      ///< The middle of what it names.
  Vec2 baseline{};  ///< Where its first letter stands; found by place_labels.
};

/// Puts each label beside its mark, where it hides no mark and no label placed before it; where
/// there is no such place, where it hides the least. `letter` is the letters' size and `page` the
/// size of the drawing, in pixels.
void place_labels(std::vector<Label>& labels, double letter, Vec2 page);

}  // namespace docent::draw
