#include "runtime/kiosk/visit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include "platform/file/read_file.h"
#include "platform/file/text_encoding.h"
#include "platform/terminal/suggest.h"
#include "platform/terminal/value.h"
#include "runtime/interface/seats.h"

namespace docent::kiosk {
namespace {

/// A word of a line and where it begins (from 1).
struct Word {
  std::string_view text;
  std::uint32_t column = 1;
};

std::vector<Word> words_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  constexpr std::string_view space = " \t\r";
  std::vector<Word> words;
  for (std::size_t at = line.find_first_not_of(space); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(space, at), line.size());
    words.push_back({line.substr(at, end - at), static_cast<std::uint32_t>(at + 1)});
    at = line.find_first_not_of(space, end);
  }
  return words;
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<float> share(std::string_view text) {
  const std::optional<double> value = number(text);
  if (!value || *value < 0 || *value > 1) return std::nullopt;
  return static_cast<float>(*value);
}

std::optional<std::uint32_t> finger(std::string_view text) {
  std::uint32_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The arguments of a form, a word each.
std::vector<std::string_view> arguments_of(const VisitForm& form) {
  return form.arguments.empty() ? std::vector<std::string_view>()
                                : terminal::split(form.arguments, ' ');
}

class LineReader {
 public:
  LineReader(std::string_view file, std::uint32_t line, std::span<const Word> words)
      : file_(file), line_(line), words_(words) {}

  /// The command of this line, or the mistake in it.
  std::optional<VisitCommand> read() {
    VisitCommand command;
    command.line = line_;
    const std::optional<double> time = number(words_[0].text);
    if (!time || *time < 0)
      return wrong(0, "bad-time", fmt::format("'{}' is not a time in seconds", words_[0].text),
                   "a line is TIME and a command, such as 2.5 tap @home");
    command.time = *time;
    if (words_.size() < 2)
      return wrong(0, "missing-command", "there is no command after the time",
                   "a line is TIME and a command, such as 2.5 tap @home");
    return read_command(command) ? std::optional(command) : std::nullopt;
  }
  std::optional<Diagnostic> mistake;

 private:
  std::nullopt_t wrong(std::size_t word, std::string code, std::string message,
                       std::string hint = {}) {
    mistake = Diagnostic{.file = std::string(file_),
                         .line = line_,
                         .column = words_[word].column,
                         .length = static_cast<std::uint32_t>(words_[word].text.size()),
                         .code = std::move(code),
                         .message = std::move(message),
                         .hint = std::move(hint)};
    return std::nullopt;
  }

  /// The forms of the command that this line names; empty, and a mistake, where there is none.
  std::vector<const VisitForm*> forms_named() {
    std::vector<const VisitForm*> forms;
    std::vector<std::string_view> verbs;
    for (const VisitForm& form : visit_forms()) {
      if (form.verb == words_[1].text) forms.push_back(&form);
      if (std::ranges::find(verbs, form.verb) == verbs.end()) verbs.push_back(form.verb);
    }
    if (!forms.empty()) return forms;
    const std::string_view meant = terminal::closest(words_[1].text, verbs);
    wrong(1, "unknown-command", fmt::format("there is no command '{}'", words_[1].text),
          meant.empty() ? fmt::format("commands are {}", fmt::join(verbs, ", "))
                        : fmt::format("did you mean '{}'?", meant));
    return forms;
  }

  /// Is this line written in that form?
  bool is_of(const VisitForm& form) const {
    const std::vector<std::string_view> arguments = arguments_of(form);
    if (words_.size() != arguments.size() + 2) return false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const std::string_view word = words_[i + 2].text;
      if (arguments[i] == "seat" && word != "seat") return false;
      if (arguments[i] == "@NAME" && !word.starts_with('@')) return false;
    }
    return true;
  }

  bool read_command(VisitCommand& command) {
    const std::vector<const VisitForm*> forms = forms_named();
    if (forms.empty()) return false;
    for (const VisitForm* form : forms)
      if (is_of(*form)) return read_arguments(*form, command);
    std::string usage;
    for (const VisitForm* form : forms)
      usage +=
          fmt::format("{}TIME {} {}", usage.empty() ? "" : ", or ", form->verb, form->arguments);
    wrong(1, "wrong-arguments", fmt::format("'{}' does not have what it needs", words_[1].text),
          fmt::format("write {}", usage));
    return false;
  }

  bool read_arguments(const VisitForm& form, VisitCommand& command) {
    command.kind = form.kind;
    const std::vector<std::string_view> arguments = arguments_of(form);
    for (std::size_t i = 0; i < arguments.size(); ++i)
      if (!read_argument(arguments[i], i + 2, command)) return false;
    return true;
  }

  bool read_argument(std::string_view argument, std::size_t word, VisitCommand& command) {
    const std::string_view text = words_[word].text;
    if (argument == "X") return read_share(word, command.contact.x);
    if (argument == "Y") return read_share(word, command.contact.y);
    if (argument == "ID") return read_finger(word, command);
    if (argument == "KEY") return read_key(word, command);
    if (argument == "NUMBER") return read_seat(word, command);
    if (argument == "in|out" && text != "in" && text != "out") {
      wrong(word, "bad-headphones", fmt::format("headphones are not '{}'", text),
            "write in, or out");
      return false;
    }
    if (argument != "seat") command.name = text.substr(argument.starts_with('@') ? 1 : 0);
    return true;
  }

  bool read_share(std::size_t word, float& place) {
    const std::optional<float> value = share(words_[word].text);
    if (value)
      place = *value;
    else
      wrong(word, "bad-place",
            fmt::format("'{}' is not a place on the screen, which runs from 0 to 1",
                        words_[word].text));
    return value.has_value();
  }

  bool read_finger(std::size_t word, VisitCommand& command) {
    const std::optional<std::uint32_t> id = finger(words_[word].text);
    if (!id)
      wrong(word, "bad-finger", fmt::format("'{}' is not a finger's number", words_[word].text));
    else
      command.contact.id = *id;
    return id.has_value();
  }

  bool read_seat(std::size_t word, VisitCommand& command) {
    const std::optional<std::uint32_t> seat = finger(words_[word].text);
    if (!seat || *seat < 1 || *seat > interface::most_seats) {
      wrong(word, "bad-seat", fmt::format("'{}' is not a seat's number", words_[word].text),
            fmt::format("seats are counted from the left, 1 to {}", interface::most_seats));
      return false;
    }
    command.seat = seat;
    return true;
  }

  bool read_key(std::size_t word, VisitCommand& command) {
    command.key = key_named(words_[word].text);
    if (command.key.key != input::Key::None) return true;
    wrong(word, "unknown-key", fmt::format("there is no key '{}'", words_[word].text),
          "keys are UP DOWN LEFT RIGHT ENTER BACK HELP VOLUME_UP VOLUME_DOWN, a letter, a digit "
          "or F1 to F24");
    return false;
  }

  std::string_view file_;
  std::uint32_t line_;
  std::span<const Word> words_;
};

}  // namespace

std::span<const VisitForm> visit_forms() noexcept {
  using Kind = VisitCommand::Kind;
  static constexpr std::array<VisitForm, 12> forms{{
      {"tap", "X Y", Kind::Tap, "A finger goes down there and up again"},
      {"tap", "@NAME", Kind::TapNamed,
       "The control or exhibit of that name is tapped, wherever it is; where another screen shows "
       "it, that one is gone to first, over at most three touches"},
      {"tap", "@NAME seat NUMBER", Kind::TapNamed,
       "The same from one seat of a shared glass, counted from the left, from 1; else the seat "
       "is the one that was touched last"},
      {"down", "ID X Y", Kind::Down, "The finger of that number goes down"},
      {"move", "ID X Y", Kind::Move, "It moves there"},
      {"up", "ID", Kind::Up, "It goes up"},
      {"key", "KEY", Kind::Press,
       "A key is pressed: UP DOWN LEFT RIGHT ENTER BACK HELP VOLUME_UP VOLUME_DOWN, a letter, a "
       "digit, or F1 to F24"},
      {"shot", "FILE.png", Kind::Shot, "The screen is written as a picture"},
      {"controls", "FILE.json", Kind::Controls,
       "Every control and label on the screen is written as JSON: name, role, label, state, "
       "rectangle, height of its capitals, what is spoken, and whether it has the focus"},
      {"today", "FILE", Kind::Today, "That file becomes today.toml: what is closed from then on"},
      {"headphones", "in|out", Kind::Headphones,
       "Headphones are plugged in, or pulled out: who has them is read to"},
      {"quit", "", Kind::Quit, "The program ends"},
  }};
  return forms;
}

input::InputEvent key_named(std::string_view name) noexcept {
  input::InputEvent event{.kind = input::InputEvent::Kind::KeyDown, .contact = {}};
  constexpr std::array<std::pair<std::string_view, input::Key>, 9> named{
      {{"UP", input::Key::Up},
       {"DOWN", input::Key::Down},
       {"LEFT", input::Key::Left},
       {"RIGHT", input::Key::Right},
       {"ENTER", input::Key::Enter},
       {"BACK", input::Key::Back},
       {"HELP", input::Key::Help},
       {"VOLUME_UP", input::Key::VolumeUp},
       {"VOLUME_DOWN", input::Key::VolumeDown}}};
  for (const auto& [text, key] : named)
    if (name == text) event.key = key;
  if (name.size() == 1) {
    const char c = name[0];
    const bool digit = c >= '0' && c <= '9', upper = c >= 'A' && c <= 'Z',
               lower = c >= 'a' && c <= 'z';
    if (digit || upper || lower) event.key = input::Key::Character;
    event.character = static_cast<char>(lower ? c - 'a' + 'A' : c);
  } else if (name.starts_with('F')) {
    const std::optional<std::uint32_t> which = finger(name.substr(1));
    if (which && *which >= 1 && *which <= 24) {
      event.key = input::Key::Function;
      event.character = static_cast<char>(*which);
    }
  }
  return event;
}

Visit parse_visit(std::string_view text, std::string_view file) {
  Visit visit;
  std::uint32_t line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<Word> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    if (words.empty()) continue;
    LineReader reader(file, line, words);
    if (std::optional<VisitCommand> command = reader.read())
      visit.commands.push_back(std::move(*command));
    else if (reader.mistake)
      visit.mistakes.push_back(std::move(*reader.mistake));
  }
  std::ranges::stable_sort(visit.commands, {}, &VisitCommand::time);
  return visit;
}

Visit load_visit(const std::filesystem::path& file) {
  const Result<std::string> bytes = file::read_file(file);
  const auto fault = bytes ? file::encoding_fault(*bytes) : std::nullopt;
  if (bytes && !fault) return parse_visit(file::without_byte_order_mark(*bytes), file.string());
  Visit visit;
  if (fault) {
    visit.mistakes.push_back({.file = file.string(),
                              .line = fault->line,
                              .column = fault->column,
                              .code = "not-utf8",
                              .message = fault->message,
                              .hint = fault->hint});
    return visit;
  }
  visit.mistakes.push_back({.file = file.string(),
                            .code = "missing-file",
                            .message = without_file(bytes.error(), file.string())});
  return visit;
}

}  // namespace docent::kiosk
