#pragma once

#include "platform/terminal/command_line.h"

namespace docent::kiosk {

/// `docent pin`: asks for a PIN, twice and unseen at a terminal, else takes it from a line of
/// standard input, and prints the line for kiosk.toml.
terminal::Command pin_command();

}  // namespace docent::kiosk
