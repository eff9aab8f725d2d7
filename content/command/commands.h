#pragma once

#include "platform/terminal/command_line.h"

/// The commands of docent-content, one file each: its options and what it does. What a command
/// throws is reported by main.
namespace docent::command {

terminal::Command compile_command();
terminal::Command check_command();
terminal::Command import_command();
terminal::Command translate_command();
terminal::Command info_command();
terminal::Command schema_command();
terminal::Command route_command();
terminal::Command at_command();
terminal::Command see_command();
terminal::Command near_command();
terminal::Command tour_command();
terminal::Command offset_command();
terminal::Command show_command();
terminal::Command figure_command();
terminal::Command graph_command();
terminal::Command walk_command();
terminal::Command film_command();
terminal::Command keygen_command();
terminal::Command sign_command();
terminal::Command verify_command();
terminal::Command release_command();

/// docent-content as a whole.
terminal::Command program();

}  // namespace docent::command
