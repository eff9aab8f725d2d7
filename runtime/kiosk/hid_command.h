#pragma once

#include "platform/terminal/command_line.h"

namespace docent::kiosk {

/// `docent hid list [--json]` and `docent hid decode FILE.hid`: which devices there are and what
/// each is taken for, and what the kiosk makes of a recording.
terminal::Command hid_command();

}  // namespace docent::kiosk
