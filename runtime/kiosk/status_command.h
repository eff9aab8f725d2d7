#pragma once

#include "platform/terminal/command_line.h"

namespace docent::kiosk {

/// `docent status [--json]`: asks the kiosk that runs here how it is.
terminal::Command status_command();

}  // namespace docent::kiosk
