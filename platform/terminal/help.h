#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "platform/terminal/colour.h"
#include "platform/terminal/command_line.h"

namespace docent::terminal {

/// An option as a command line shows it: "[--radius R]...", "-o FILE", "SOURCE...".
std::string synopsis_of(const Option& option);

/// An option as a list shows it: "-o, --output FILE".
std::string heading_of(const Option& option);

/// What is said of an option: its sentence, what holds otherwise, whether it is needed.
std::string description_of(const Option& option);

/// The options that every command has besides those of its table.
std::vector<Option> common_options(bool is_program);

/// What --help prints of a command; `path` is how it is called: "docent hid list".
std::string help(const Command& command, std::string_view path, bool is_program, ColourUse colour);

}  // namespace docent::terminal
