#pragma once

#include <functional>
#include <optional>

#include "runtime/interface/column.h"

namespace docent::interface {

/// How large a museum's sign is at most, in units; in its own shape.
struct LogoSize {
  float units_high = 11, units_wide = 44;
};

/// The museum's sign, for the welcome screen: at the start of the width that there is for it.
struct Logo {
  std::function<float(float)> width;  ///< Of it, where there is so much.
  Block block;
};

/// On paper of the day where it would not be told from that of the night. None: the museum has
/// none.
std::optional<Logo> logo_of(Sheet& sheet, LogoSize most = {});

}  // namespace docent::interface
