#include "tests/deploy/completions.h"

#include <fmt/format.h>

#include <algorithm>

#include "platform/terminal/help.h"

namespace docent::test {
namespace {

using terminal::Command;
using terminal::Offers;
using terminal::Option;

std::string function_of(std::string_view path) {
  std::string name = fmt::format("_{}", path);
  std::ranges::replace_if(name, [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

std::vector<Option> options_of(const Command& command, bool is_program) {
  std::vector<Option> options = command.options;
  std::ranges::copy(terminal::common_options(is_program), std::back_inserter(options));
  return options;
}

/// Calls visit(command, path, is_program) for a command and all below it.
void for_each(const Command& command, const std::string& path, bool is_program, auto&& visit) {
  visit(command, path, is_program);
  for (const Command& each : command.commands)
    for_each(each, fmt::format("{} {}", path, each.name), false, visit);
}

// ---- bash

std::string bash_words(const std::vector<std::string_view>& words) {
  return fmt::format("_docent_offer -W '{}'", fmt::join(words, " "));
}

std::string bash_offer(const terminal::Value& value) {
  if (!value.choices.empty()) return bash_words(value.choices);
  if (value.offers == Offers::Files) return "_docent_offer -f";
  return value.offers == Offers::Folders ? "_docent_offer -d" : ":";
}

/// After an option that takes a value, only that value makes sense.
std::string bash_values(const Command& command, const std::string& path) {
  std::string cases;
  for (const Option& option : command.options) {
    if (terminal::is_flag(option) || terminal::is_positional(option)) continue;
    std::string patterns;
    for (const std::string_view name : terminal::names_of(option))
      patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", path, name);
    cases += fmt::format("    {}) {}; return ;;\n", patterns, bash_offer(option.value));
  }
  return cases;
}

std::string bash_rest(const Command& command, const std::string& path, bool is_program) {
  std::vector<std::string_view> names, commands;
  std::string offer = ":";
  for (const Option& option : options_of(command, is_program)) {
    if (terminal::is_positional(option))
      offer = bash_offer(option.value);
    else
      std::ranges::copy(terminal::names_of(option), std::back_inserter(names));
  }
  for (const Command& each : command.commands) commands.push_back(each.name);
  if (!commands.empty()) offer = bash_words(commands);
  return fmt::format("    '{}') if [[ $word == -* ]]; then {}; else {}; fi ;;\n", path,
                     bash_words(names), offer);
}

// ---- zsh

/// Text inside of single quotes and of a specification of _arguments.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  }
  return out;
}

std::string zsh_action(const terminal::Value& value) {
  if (!value.choices.empty()) return fmt::format("({})", fmt::join(value.choices, " "));
  if (value.offers == Offers::Files) return "_files";
  return value.offers == Offers::Folders ? "_files -/" : "";
}

std::string zsh_option(const Option& option) {
  const std::string takes =
      terminal::is_flag(option)
          ? std::string()
          : fmt::format(":{}:{}", zsh_text(option.value.name), zsh_action(option.value));
  if (terminal::is_positional(option))
    return fmt::format("    '{}{}'", terminal::may_repeat(option) ? "*" : "", takes);
  const std::vector<std::string_view> names = terminal::names_of(option);
  const std::string help = zsh_text(option.manual);
  if (terminal::may_repeat(option)) return fmt::format("    '*{}[{}]{}'", names[0], help, takes);
  std::string specifications;
  for (const std::string_view name : names)
    specifications += fmt::format("{}    '({}){}[{}]{}'", specifications.empty() ? "" : " \\\n",
                                  fmt::join(names, " "), name, help, takes);
  return specifications;
}

std::string zsh_function(const Command& command, const std::string& path, bool is_program) {
  std::string text = fmt::format("{}() {{\n", function_of(path));
  if (!command.commands.empty()) text += "  local curcontext=$curcontext state line\n";
  text += "  _arguments -s -C";
  for (const Option& option : options_of(command, is_program)) text += " \\\n" + zsh_option(option);
  if (command.commands.empty()) return text + "\n}\n\n";
  std::string commands, cases;
  for (const Command& each : command.commands) {
    commands += fmt::format(" {}\\:\"{}\"", each.name, zsh_text(each.manual));
    cases += fmt::format("    {}) {} ;;\n", each.name,
                         function_of(fmt::format("{} {}", path, each.name)));
  }
  return text + fmt::format(
                    " \\\n    '1:command:(({}))' \\\n    '*::argument:->command'\n"
                    "  [[ $state == command ]] && case $words[1] in\n{}  esac\n}}\n\n",
                    commands.substr(1), cases);
}

}  // namespace

std::string bash_completion(const Command& program) {
  std::string paths, values, rest;
  for_each(program, std::string(program.name), true,
           [&](const Command& command, const std::string& path, bool is_program) {
             if (!is_program) paths += fmt::format("{}'{}'", paths.empty() ? "" : " | ", path);
             values += bash_values(command, path);
             rest += bash_rest(command, path, is_program);
           });
  return fmt::format(
      "# bash completion for {0}; made of its table of options by tests/deploy.\n"
      "_docent_offer() {{\n  [[ $1 == -W ]] || compopt -o filenames\n"
      "  mapfile -t COMPREPLY < <(compgen \"$@\" -- \"$word\")\n}}\n"
      "{1}() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} path={0} i\n"
      "  COMPREPLY=()\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    case \"$path ${{COMP_WORDS[i]}}\" in\n"
      "    {2}) path+=\" ${{COMP_WORDS[i]}}\" ;;\n"
      "    esac\n  done\n"
      "  case \"$path $before\" in\n{3}  esac\n"
      "  case \"$path\" in\n{4}  esac\n}}\n"
      "complete -F {1} {0}\n",
      program.name, function_of(program.name), paths, values, rest);
}

std::string zsh_completion(const Command& program) {
  std::string text = fmt::format(
      "#compdef {}\n# Made of the program's table of options by tests/deploy.\n\n", program.name);
  for_each(program, std::string(program.name), true,
           [&](const Command& command, const std::string& path, bool is_program) {
             text += zsh_function(command, path, is_program);
           });
  return text + fmt::format("{} \"$@\"\n", function_of(program.name));
}

}  // namespace docent::test
