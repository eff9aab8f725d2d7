#pragma once

#include <span>

#include "content/scenery/scenery.h"

namespace docent::scenery {

/// Gives each area a tint that no neighbour has, as far as there are enough; of those the one that
/// is on the least of the floor so far, so that all are used.
void tint_apart(std::span<PavedArea> areas);

}  // namespace docent::scenery
