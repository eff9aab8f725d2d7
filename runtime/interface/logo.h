#pragma once

#include <optional>

#include "runtime/interface/column.h"

namespace docent::interface {

/// The museum's sign, for the welcome screen: as high or as wide as such a sign needs, and on paper
/// of the day where it would not be told from that of the night. None: the museum has none.
std::optional<Block> logo_block(Sheet& sheet);

}  // namespace docent::interface
