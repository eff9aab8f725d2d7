#pragma once

#include <expected>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "platform/terminal/value.h"
#include "runtime/model/diagnostic.h"

/// Commands and options as tables: what reads a command line, prints its help, and writes the
/// manual pages and the shells' completions.
namespace docent::terminal {

/// How often an option is given.
enum class Times : std::uint8_t { AtMostOnce, Once, AnyNumber, AtLeastOnce };

/// An option, or a value that stands without one: a line of a table.
struct Option {
  std::string_view names;  ///< "--json"; "-o,--output"; "SOURCE"; a flag with its contrary:
                           ///< "--turns,!--no-turns".
  Value value{};
  std::string_view manual{};  ///< What it does, as a sentence without a full stop.
  Times times = Times::AtMostOnce;
  std::string_view otherwise{};  ///< What holds where it is not given; may be empty.
};

/// A list for people after the options: files, signals, exit codes.
struct Section {
  std::string_view title;
  std::vector<std::pair<std::string_view, std::string_view>> rows;
};

/// A program, or one of its commands. The options' values are stored where `run` finds them.
struct Command {
  std::string_view name;
  std::string_view manual;  ///< What it does: a verb and what follows, without a full stop.
  std::vector<Option> options{};
  /// Does it; returns the exit code. Empty where one of `commands` has to be named.
  std::function<int()> run{};
  std::vector<Command> commands{};
  std::vector<Section> sections{};
};

/// The version of both programs.
std::string_view version() noexcept;

/// The exit codes that every command of ours has.
Section exit_codes();

/// The words of an option, without what separates and negates them: "-o", "--output".
std::vector<std::string_view> names_of(const Option& option);
bool is_flag(const Option& option) noexcept;
/// Is it told by its place, as a file is, and not by a name?
bool is_positional(const Option& option) noexcept;
bool is_needed(const Option& option) noexcept;
bool may_repeat(const Option& option) noexcept;

/// Reads a command line, without the program's own name, and stores what it says. The function that
/// comes back does the rest: it is the command's own, or one that prints the help or the version.
/// Where the line is wrong, a diagnostic comes back instead, for exit code 2. Throws nothing but
/// std::bad_alloc.
std::expected<std::function<int()>, Diagnostic> parse(const Command& program,
                                                      std::span<const char* const> arguments);

}  // namespace docent::terminal
