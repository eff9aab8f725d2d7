#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/interface/measures.h"
#include "runtime/interface/view.h"
#include "runtime/model/museum.h"

namespace docent::interface {

/// A control or a label as it lies on the glass: what somebody who does not see it is told, and
/// what tests measure.
struct OnGlass {
  std::string name;       ///< Of a control. Labels have none.
  std::string_view role;  ///< "button", "list-item", "spot", "choice"; of a label "text".
  std::string label;
  std::string_view state;  ///< "normal", "selected" or "disabled".
  scene::Rect rect;        ///< Screen frame: of a control, where it is touched.
  float text_mm = 0;       ///< How high the capitals are on the glass; 0 where it is a picture.
  std::string spoken;      ///< What is said of it.
  bool has_focus = false;  ///< The keypad's.
};

/// Everything that can be touched or read in a view: controls in focus order, then labels that
/// belong to none. `remaining`: metres still to walk. `focus`: index of a control, or -1.
std::vector<OnGlass> on_glass(const Museum& museum, const View& view, const ScreenShape& shape,
                              float remaining, std::int32_t focus, float offset = 0);

/// Those that cover each other, as pairs of indices. Up to a pixel is no overlap: texts stand on
/// whole pixels.
std::vector<std::pair<std::size_t, std::size_t>> overlaps(const std::vector<OnGlass>& items,
                                                          const ScreenShape& shape);
/// Those that leave the screen.
std::vector<std::size_t> outside(const std::vector<OnGlass>& items, const ScreenShape& shape);

}  // namespace docent::interface
