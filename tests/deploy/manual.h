#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/manual.h"
#include "platform/terminal/command_line.h"

/// Tables as mdoc(7), the language of manual pages.
namespace docent::test {

/// A sentence as a line of text, with what would be a macro or an escape made harmless.
std::string mdoc_text(std::string_view sentence);

/// The options of a command, one below the other.
std::string mdoc_options(const terminal::Command& command);

/// How a command is called: the lines of a SYNOPSIS after its name.
std::string mdoc_synopsis(const terminal::Command& command);

/// All commands of a program with their options, a subsection each.
std::string mdoc_commands(const terminal::Command& program);

/// The rows of the section of that title.
std::string mdoc_section(const terminal::Command& program, std::string_view title);

/// Fields of a file, a subsection for each section that has a name.
std::string mdoc_fields(const std::vector<config::SectionManual>& sections);

/// The commands of a scripted visit.
std::string mdoc_visit();

/// The tables and columns of a schema, with what stands beside them.
std::string mdoc_tables(std::string_view sql);

/// A page as it was written by hand, with each line "@NAME@" and each word "@NAME@" replaced.
std::string filled(std::string text,
                   const std::vector<std::pair<std::string_view, std::string>>& parts);

}  // namespace docent::test
