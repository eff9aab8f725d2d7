#include "platform/terminal/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>  // here alone: it takes seconds to compile
#include <algorithm>
#include <optional>

#include "platform/terminal/help.h"
#include "platform/terminal/suggest.h"

namespace docent::terminal {
namespace {

Diagnostic mistake(std::string_view what, std::string code, std::string message,
                   std::string hint = {}) {
  return {.file = std::string(what),
          .code = std::move(code),
          .message = std::move(message),
          .hint = std::move(hint)};
}

/// A command as CLI11 knows it, which divides the line into words of options. What the words mean
/// is said here, so that a mistake is told in the same words everywhere.
struct Node {
  const Command& command;
  CLI::App& app;
  std::string path;  ///< "docent hid list"
  bool is_program;
  std::vector<CLI::Option*> options{};  ///< One each of the command's.
};

CLI::Option* add_option(CLI::App& app, const Option& option) {
  if (is_flag(option)) return app.add_flag(std::string(option.names));
  CLI::Option* const added = app.add_option(std::string(option.names));
  const bool many_at_a_place = is_positional(option) && may_repeat(option);
  added->type_size(1)->expected(1, many_at_a_place ? -1 : 1);
  added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return added->allow_extra_args(many_at_a_place);
}

void add_command(const Command& command, CLI::App& app, bool is_program) {
  app.allow_extras();
  for (const Option& option : command.options) add_option(app, option);
  if (is_program) app.set_version_flag("--version", std::string(version()));
  for (const Command& each : command.commands)
    add_command(each, *app.add_subcommand(std::string(each.name)), false);
}

/// The command that a line has named.
Node named_command(const Command& program, CLI::App& app) {
  const Command* command = &program;
  CLI::App* at = &app;
  std::string path(program.name);
  for (auto named = at->get_subcommands(); !named.empty(); named = at->get_subcommands()) {
    at = named.front();
    command = &*std::ranges::find(command->commands, at->get_name(), &Command::name);
    path.append(" ").append(at->get_name());
  }
  Node node{*command, *at, std::move(path), command == &program};
  for (const Option& option : command->options)
    node.options.push_back(at->get_option(std::string(names_of(option).front())));
  return node;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known,
                         const std::string& otherwise) {
  const std::string_view meant = closest(word, known);
  return meant.empty() ? otherwise : fmt::format("did you mean '{}'?", meant);
}

/// What to say of a word that is nothing here: an option, a command, or one argument too many.
Diagnostic unknown_word(const Node& node, std::string_view word) {
  std::vector<std::string_view> known;
  if (word.starts_with('-') && word.size() > 1) {
    word = word.substr(0, word.find('='));
    std::vector<Option> options = common_options(node.is_program);
    std::ranges::copy(node.command.options, std::back_inserter(options));
    for (const Option& option : options)
      if (!is_positional(option)) std::ranges::copy(names_of(option), std::back_inserter(known));
    return mistake(word, "unknown-option", fmt::format("{} has no such option", node.path),
                   did_you_mean(word, known, node.path + " --help lists the options"));
  }
  if (node.command.commands.empty())
    return mistake(word, "extra-argument",
                   fmt::format("{} does not expect this argument", node.path),
                   node.path + " --help says what it expects");
  for (const Command& command : node.command.commands) known.push_back(command.name);
  return mistake(word, "unknown-command", fmt::format("{} has no such command", node.path),
                 did_you_mean(word, known, fmt::format("it has {}", fmt::join(known, ", "))));
}

/// Stores what was given for one option; what is wrong with it, if anything.
std::optional<Diagnostic> take(const Node& node, const Option& option, const CLI::Option& given) {
  const std::vector<std::string>& words = given.results();
  const std::string_view name = names_of(option).back();
  if (words.empty()) {
    if (!is_needed(option)) return {};
    return mistake(name, "missing-argument",
                   fmt::format("{} needs {}", node.path, heading_of(option)),
                   std::string(option.manual));
  }
  if (!is_flag(option) && !may_repeat(option) && words.size() > 1)
    return mistake(name, "repeated-option",
                   fmt::format("this is given {} times; say it once", words.size()));
  std::string wrong = option.value.take(words);
  if (wrong.empty()) return {};
  return mistake(name, "bad-value", std::move(wrong));
}

std::expected<std::function<int()>, Diagnostic> take_all(const Node& node) {
  if (const std::vector<std::string> unknown = node.app.remaining(); !unknown.empty())
    return std::unexpected(unknown_word(node, unknown.front()));
  for (std::size_t i = 0; i < node.options.size(); ++i)
    if (auto wrong = take(node, node.command.options[i], *node.options[i]))
      return std::unexpected(std::move(*wrong));
  if (node.command.run) return node.command.run;
  std::vector<std::string_view> known;
  for (const Command& command : node.command.commands) known.push_back(command.name);
  return std::unexpected(mistake(node.path, "missing-command",
                                 "say what to do: a command is missing",
                                 fmt::format("it has {}", fmt::join(known, ", "))));
}

std::function<int()> printing(std::string text) {
  return [text = std::move(text)] {
    fmt::print("{}", text);
    return 0;
  };
}

}  // namespace

std::string_view version() noexcept {
  return DOCENT_VERSION;
}

Section exit_codes() {
  return {.title = "exit codes",
          .rows = {{"0", "Done"},
                   {"1", "The input has errors, and every one of them was told"},
                   {"2", "The command line is wrong"},
                   {"3", "The environment failed: a device, the disk, a permission"}}};
}

std::vector<std::string_view> names_of(const Option& option) {
  std::vector<std::string_view> names = split(option.names, ',');
  for (std::string_view& name : names)
    if (name.starts_with('!')) name.remove_prefix(1);
  return names;
}

bool is_flag(const Option& option) noexcept {
  return option.value.name.empty() && !is_positional(option);
}
bool is_positional(const Option& option) noexcept {
  return !option.names.starts_with('-');
}
bool is_needed(const Option& option) noexcept {
  return option.times == Times::Once || option.times == Times::AtLeastOnce;
}
bool may_repeat(const Option& option) noexcept {
  return option.times == Times::AnyNumber || option.times == Times::AtLeastOnce;
}

std::expected<std::function<int()>, Diagnostic> parse(const Command& program,
                                                      std::span<const char* const> arguments) {
  CLI::App app("", std::string(program.name));
  add_command(program, app, true);
  std::vector<std::string> words(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
  try {
    app.parse(std::move(words));
    return take_all(named_command(program, app));
  } catch (const CLI::CallForHelp&) {
    const Node node = named_command(program, app);
    return printing(help(node.command, node.path, node.is_program, colour_use_of(stdout)));
  } catch (const CLI::CallForVersion&) {
    return printing(fmt::format("{} {}\n", program.name, version()));
  } catch (const CLI::ArgumentMismatch& error) {  // "--floor: 1 required TEXT missing"
    const std::string_view told = error.what();
    return std::unexpected(
        mistake(told.substr(0, told.find(':')), "missing-value", "this option needs a value"));
  } catch (const CLI::Error& error) {
    return std::unexpected(mistake(program.name, "wrong-usage", error.what()));
  }
}

}  // namespace docent::terminal
