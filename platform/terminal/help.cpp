#include "platform/terminal/help.h"

#include <fmt/format.h>

#include <algorithm>

namespace docent::terminal {
namespace {

constexpr std::size_t page_width = 80, text_column = 27;

/// Appends words to a text whose last line has `column` characters; later lines begin at `indent`.
template <typename Words>
void wrap(const Words& words, std::size_t column, std::size_t indent, std::string& text) {
  bool is_first = true;
  for (const auto& word : words) {
    if (!is_first && column + 1 + word.size() > page_width) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      text += ' ';
      ++column;
    }
    text += word;
    column += word.size();
    is_first = false;
  }
  text += '\n';
}

std::string title(std::string_view words, ColourUse colour) {
  return fmt::format("\n{}:\n", painted(words, Ink::Bold, colour));
}

/// A heading, and beside or below it what is said of it.
void add_row(std::string_view heading, std::string_view manual, std::string& text) {
  text += fmt::format("  {}", heading);
  if (heading.size() + 4 > text_column)
    text += '\n' + std::string(text_column, ' ');
  else
    text += std::string(text_column - 2 - heading.size(), ' ');
  wrap(split(manual, ' '), text_column, text_column, text);
}

void add_options(std::string_view heading, const std::vector<Option>& options, bool positional,
                 ColourUse colour, std::string& text) {
  bool is_first = true;
  for (const Option& option : options) {
    if (is_positional(option) != positional) continue;
    if (is_first) text += title(heading, colour);
    is_first = false;
    add_row(heading_of(option), description_of(option), text);
  }
}

/// The call as a whole: what is told by its place first.
std::vector<std::string> usage(const Command& command, std::string_view path) {
  std::vector<std::string> words{std::string(path)};
  for (const bool positional : {true, false})
    for (const Option& option : command.options)
      if (is_positional(option) == positional) words.push_back(synopsis_of(option));
  if (!command.commands.empty() && !command.run) words.emplace_back("COMMAND ...");
  return words;
}

}  // namespace

std::string synopsis_of(const Option& option) {
  std::string words(names_of(option).front());
  if (!is_positional(option) && !is_flag(option)) words.append(" ").append(option.value.name);
  if (!is_needed(option)) words = fmt::format("[{}]", words);
  return may_repeat(option) ? words + "..." : words;
}

std::string heading_of(const Option& option) {
  std::string words = fmt::format("{}", fmt::join(names_of(option), ", "));
  if (!is_positional(option) && !is_flag(option)) words.append(" ").append(option.value.name);
  return words;
}

std::string description_of(const Option& option) {
  std::string words(option.manual);
  if (!option.otherwise.empty()) words += fmt::format("; default {}", option.otherwise);
  if (is_needed(option) && !is_positional(option)) words += " (needed)";
  if (may_repeat(option) && !is_positional(option)) words += " (may be repeated)";
  return words;
}

std::vector<Option> common_options(bool is_program) {
  std::vector<Option> options{{.names = "-h,--help", .manual = "Print this help"}};
  if (is_program) options.push_back({.names = "--version", .manual = "Print the version"});
  return options;
}

std::string help(const Command& command, std::string_view path, bool is_program, ColourUse colour) {
  std::string text;
  wrap(split(fmt::format("{}: {}.", path, command.manual), ' '), 0, 0, text);
  text += fmt::format("\n{}: ", painted("usage", Ink::Bold, colour));
  wrap(usage(command, path), 7, 7, text);
  add_options("arguments", command.options, true, colour, text);
  std::vector<Option> options = command.options;
  std::ranges::copy(common_options(is_program), std::back_inserter(options));
  add_options("options", options, false, colour, text);
  if (!command.commands.empty()) text += title("commands", colour);
  for (const Command& each : command.commands) add_row(each.name, each.manual, text);
  for (const Section& section : command.sections) {
    text += title(section.title, colour);
    for (const auto& [name, manual] : section.rows) add_row(name, manual, text);
  }
  if (!command.commands.empty())
    text += fmt::format("\n{} COMMAND --help tells of a command.\n", path);
  return text;
}

}  // namespace docent::terminal
