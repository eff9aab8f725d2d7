#pragma once

#include <ostream>
#include <vector>

#include "tests/content/import/building/drawn_plan.h"

namespace docent::test {

/// A manner of drawing, and how thick the walls of what it draws are.
struct DrawnManner {
  DrawingManner manner;
  double wall = 0.2;  ///< Metres.
};

/// The name is what a test's sentence says of it.
void PrintTo(const DrawnManner& drawn, std::ostream* out);

/// The manners in which plans come: units, layers of many languages, kinds of doors, mess.
std::vector<DrawnManner> drawn_manners();

}  // namespace docent::test
