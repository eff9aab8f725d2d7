#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "content/import/drawing/drawing.h"

namespace docent::import {

/// Metres of a unit by its name: `mm`, `cm`, `dm`, `m`, `in`, `inch`, `ft`, `foot`, `yard`, `km`;
/// by a number of metres, `0.0254`; or `1:50`, which are millimetres of paper at that scale.
std::optional<double> metres_of(std::string_view unit);

/// How a drawing's unit was settled.
struct UnitFound {
  double metres = 1;    ///< Of one unit.
  std::string said;     ///< `stated: mm`, for the report.
  std::string doubt;    ///< A sentence where the doors speak against what is stated.
  std::string refused;  ///< A sentence where it cannot be known: nothing stated, nothing to go by.
};

/// The unit: what staff say wins, then what the file states, if its doors are as wide as doors are;
/// else the only unit in which they would be. `leaves` are the radii of what may be door swings.
UnitFound find_unit(const Drawing& drawing, const std::vector<double>& leaves,
                    std::string_view by_staff);

/// The drawing in metres.
void scale(Drawing& drawing, double metres);

}  // namespace docent::import
