#pragma once

#include <vector>

#include "content/import/floor/imported_plan.h"
#include "runtime/model/diagnostic.h"

namespace docent::compile {

/// A slit between two parts of a drawn plan that are joined nowhere else.
struct PlanGap {
  double width = 0;  ///< Metres, above 0 and at most `widest_gap`.
  Vec2 at{};         ///< Beside it, floor frame.
  import::SourcePlace place;
};

/// Rooms of one building have a wall between them; what is nearer was meant to touch. Metres.
inline constexpr double widest_gap = 0.05;

/// The slits that keep parts of a plan apart, in the order of the file: at most one between any two
/// parts. Areas that touch or overlap are one part.
std::vector<PlanGap> plan_gaps(const import::ImportedPlan& plan);

/// Doorways that lead nowhere: areas as small and thin as those in a wall that touch one other area
/// only. As warnings.
std::vector<Diagnostic> dangling_doorways(const import::ImportedPlan& plan);

}  // namespace docent::compile
