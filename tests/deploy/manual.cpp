#include "tests/deploy/manual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "platform/terminal/help.h"
#include "runtime/kiosk/visit.h"

namespace docent::test {
namespace {

using terminal::Command;
using terminal::Option;

/// An argument of a macro: quoted where it holds blanks.
std::string argument(std::string_view word) {
  const std::string text = mdoc_text(word);
  return text.find(' ') == std::string::npos ? text : fmt::format("\"{}\"", text);
}

/// "Fl o , Fl -output Ar FILE", or "Ar SOURCE".
std::string item_of(const Option& option) {
  std::string words;
  for (const std::string_view name : terminal::names_of(option)) {
    const bool positional = terminal::is_positional(option);
    if (!words.empty()) words += " , ";
    words += positional ? fmt::format("Ar {}", name) : fmt::format("Fl {}", name.substr(1));
  }
  if (!terminal::is_flag(option) && !terminal::is_positional(option))
    words += fmt::format(" Ar {}", argument(option.value.name));
  return words;
}

std::string sentence(std::string_view text) {
  std::string words = mdoc_text(text);
  if (words.empty()) return words;
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words + ".\n";
}

/// One list of pairs: ".It HEADING" and what is said of it.
class List {
 public:
  void add(std::string_view heading, std::string_view text) {
    items_ += fmt::format(".It {}\n{}", heading, text);
  }
  /// `width`: how far what is said stands to the right of a short heading.
  std::string text(std::string_view width = "Ds") const {
    return items_.empty() ? items_ : fmt::format(".Bl -tag -width {}\n{}.El\n", width, items_);
  }

 private:
  std::string items_;
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

void add_commands(const Command& command, const std::string& path, std::string& text) {
  for (const Command& each : command.commands) {
    const std::string called = path + std::string(each.name);
    if (each.run)
      text += fmt::format(".Ss {}\n{}.Pp\n.Nm\n.Cm {}\n{}{}", called, sentence(each.manual), called,
                          mdoc_synopsis(each), mdoc_options(each));
    add_commands(each, called + " ", text);
  }
}

}  // namespace

std::string mdoc_text(std::string_view sentence) {
  std::string text;
  for (const char c : trimmed(sentence)) text += c == '\\' ? std::string("\\e") : std::string(1, c);
  if (text.starts_with('.') || text.starts_with('\'')) text.insert(0, "\\&");
  return text;
}

std::string mdoc_options(const Command& command) {
  List list;
  for (const Option& option : command.options)
    list.add(item_of(option), sentence(terminal::description_of(option)));
  return list.text();
}

std::string mdoc_synopsis(const Command& command) {
  std::string text;
  for (const bool positional : {true, false})
    for (const Option& option : command.options) {
      if (terminal::is_positional(option) != positional) continue;
      Option first = option;
      first.names = terminal::names_of(option).front();
      const std::string item = item_of(first);
      const bool repeats = terminal::may_repeat(option);
      if (terminal::is_needed(option))
        text += fmt::format(".{}{}\n", item, repeats ? " ..." : "");
      else
        text += repeats ? fmt::format(".Oo {} Oc Ns ...\n", item) : fmt::format(".Op {}\n", item);
    }
  return text;
}

std::string mdoc_commands(const Command& program) {
  std::string text;
  add_commands(program, "", text);
  return text;
}

std::string mdoc_section(const Command& program, std::string_view title) {
  const auto section = std::ranges::find(program.sections, title, &terminal::Section::title);
  List list;
  if (section != program.sections.end())
    for (const auto& [name, manual] : section->rows)
      list.add((name.starts_with('/') ? "Pa " : "") + mdoc_text(name), sentence(manual));
  return list.text();
}

std::string mdoc_fields(const std::vector<config::SectionManual>& sections) {
  std::string text;
  for (const config::SectionManual& section : sections) {
    if (!section.heading.empty())
      text += fmt::format(".Ss {}\n{}", section.heading, sentence(section.manual));
    List list;
    for (const config::FieldManual& field : section.fields)
      list.add(fmt::format("Ic {} No = {}", field.key, argument(field.kind)),
               sentence(field.manual) + (field.is_needed ? "Needed.\n" : ""));
    text += list.text();
  }
  return text;
}

std::string mdoc_visit() {
  List list;
  for (const kiosk::VisitForm& form : kiosk::visit_forms()) {
    std::string heading = fmt::format("Ar TIME Cm {}", form.verb);
    for (const std::string_view word : terminal::split(form.arguments, ' '))
      if (!word.empty()) heading += fmt::format(" {} {}", word == "seat" ? "Cm" : "Ar", word);
    list.add(heading, sentence(form.manual));
  }
  return list.text();
}

std::string mdoc_tables(std::string_view sql) {
  std::string text;
  List columns;
  for (const std::string_view line : terminal::split(sql, '\n')) {
    const std::size_t dashes = line.find("--");
    std::string_view code = trimmed(line.substr(0, dashes));
    const std::string_view comment =
        dashes == std::string_view::npos ? std::string_view() : trimmed(line.substr(dashes + 2));
    constexpr std::string_view create = "CREATE TABLE ";
    if (code.starts_with(create)) {
      code.remove_prefix(create.size());
      text += fmt::format(".Ss {}\n{}", code.substr(0, code.find(' ')), sentence(comment));
      columns = {};
    } else if (code.starts_with(')')) {
      text += columns.text("24n -compact");
    } else if (!code.empty() && !code.starts_with("PRIMARY KEY")) {
      const std::vector<std::string_view> words = terminal::split(code, ' ');
      const std::string_view type = words[1].substr(0, words[1].find(','));
      columns.add(fmt::format("Va {} Vt {}", words[0], type),
                  comment.empty() ? std::string() : mdoc_text(comment) + "\n");
    }
  }
  return text;
}

std::string filled(std::string text,
                   const std::vector<std::pair<std::string_view, std::string>>& parts) {
  for (const auto& [name, part] : parts) {
    const std::string line = fmt::format("@{}@\n", name), word = fmt::format("@{}@", name);
    for (std::size_t at = 0; (at = text.find(line, at)) != std::string::npos; at += part.size())
      text.replace(at, line.size(), part.ends_with('\n') ? part : part + "\n");
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += part.size())
      text.replace(at, word.size(), part);
  }
  return text;
}

}  // namespace docent::test
