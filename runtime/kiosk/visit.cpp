#include "runtime/kiosk/visit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include "platform/file/read_file.h"
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
      return wrong(0, "missing-command", "there is no command after the time", commands);
    return read_command(command) ? std::optional(command) : std::nullopt;
  }
  std::optional<Diagnostic> mistake;

 private:
  static constexpr const char* commands = "commands are tap, down, move, up, key, shot and quit";

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

  bool has(std::size_t arguments, const char* usage) {
    if (words_.size() == arguments + 2) return true;
    wrong(1, "wrong-arguments", fmt::format("'{}' does not have what it needs", words_[1].text),
          fmt::format("write {}", usage));
    return false;
  }

  bool read_point(std::size_t word, VisitCommand& command) {
    for (const std::size_t i : {word, word + 1}) {
      const std::optional<float> value = share(words_[i].text);
      if (!value) {
        wrong(i, "bad-place",
              fmt::format("'{}' is not a place on the screen, which runs from 0 to 1",
                          words_[i].text));
        return false;
      }
      (i == word ? command.contact.x : command.contact.y) = *value;
    }
    return true;
  }

  bool read_finger(VisitCommand& command) {
    const std::optional<std::uint32_t> id = finger(words_[2].text);
    if (!id)
      wrong(2, "bad-finger", fmt::format("'{}' is not a finger's number", words_[2].text));
    else
      command.contact.id = *id;
    return id.has_value();
  }

  bool read_seat(VisitCommand& command) {
    const std::optional<std::uint32_t> seat = finger(words_[4].text);
    if (!seat || *seat < 1 || *seat > interface::most_seats) {
      wrong(4, "bad-seat", fmt::format("'{}' is not a seat's number", words_[4].text),
            fmt::format("seats are counted from the left, 1 to {}", interface::most_seats));
      return false;
    }
    command.seat = *seat;
    return true;
  }

  bool read_command(VisitCommand& command) {
    using Kind = VisitCommand::Kind;
    const std::string_view verb = words_[1].text;
    if (verb == "tap" && words_.size() > 2 && words_[2].text.starts_with('@')) {
      command.kind = Kind::TapNamed;
      command.name = words_[2].text.substr(1);
      const bool at_seat = words_.size() > 3 && words_[3].text == "seat";
      if (!at_seat) return has(1, "TIME tap @NAME, or TIME tap @NAME seat NUMBER");
      return has(3, "TIME tap @NAME seat NUMBER") && read_seat(command);
    }
    if (verb == "tap") {
      command.kind = Kind::Tap;
      return has(2, "TIME tap X Y, or TIME tap @NAME") && read_point(2, command);
    }
    if (verb == "down" || verb == "move") {
      command.kind = verb == "down" ? Kind::Down : Kind::Move;
      return has(3, "TIME down ID X Y") && read_finger(command) && read_point(3, command);
    }
    if (verb == "up") {
      command.kind = Kind::Up;
      return has(1, "TIME up ID") && read_finger(command);
    }
    if (verb == "key") {
      command.kind = Kind::Press;
      if (!has(1, "TIME key NAME")) return false;
      command.key = key_named(words_[2].text);
      if (command.key.key != input::Key::None) return true;
      wrong(2, "unknown-key", fmt::format("there is no key '{}'", words_[2].text),
            "keys are UP DOWN LEFT RIGHT ENTER BACK HELP VOLUME_UP VOLUME_DOWN, a letter, a digit "
            "or F1 to F24");
      return false;
    }
    if (verb == "shot") {
      command.kind = Kind::Shot;
      if (!has(1, "TIME shot FILE.png")) return false;
      command.name = words_[2].text;
      return true;
    }
    if (verb == "quit") {
      command.kind = Kind::Quit;
      return has(0, "TIME quit");
    }
    wrong(1, "unknown-command", fmt::format("there is no command '{}'", verb), commands);
    return false;
  }

  std::string_view file_;
  std::uint32_t line_;
  std::span<const Word> words_;
};

}  // namespace

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
  const Result<std::string> text = file::read_file(file);
  if (text) return parse_visit(*text, file.string());
  Visit visit;
  visit.mistakes.push_back({.file = file.string(),
                            .code = "missing-file",
                            .message = without_file(text.error(), file.string())});
  return visit;
}

}  // namespace docent::kiosk
