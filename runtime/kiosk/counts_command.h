#pragma once

#include "platform/terminal/command_line.h"

namespace docent::kiosk {

/// `docent counts`: the anonymous counts of all days that are over, as CSV.
terminal::Command counts_command();

}  // namespace docent::kiosk
