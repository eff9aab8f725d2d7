#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/input/contact.h"
#include "runtime/model/diagnostic.h"

namespace docent::kiosk {

/// One command of a scripted visit.
struct VisitCommand {
  enum class Kind : std::uint8_t {
    Tap,
    TapNamed,
    Down,
    Move,
    Up,
    Press,
    Shot,
    Controls,
    Today,
    Headphones,
    Quit
  };
  double time = 0;  ///< Seconds since the first frame.
  Kind kind = Kind::Quit;
  input::Contact contact;  ///< Tap, Down, Move, Up.
  input::InputEvent key;   ///< Press.
  /// TapNamed: the control's name without "@". Shot, Controls, Today: the file. Headphones: "in" or
  /// "out".
  std::string name;
  /// TapNamed, on a shared glass: the seat that taps, counted from the left, from 1; none: the part
  /// that was touched last.
  std::optional<std::uint32_t> seat{};
  std::uint32_t line = 0;
};

/// How a command is written after its time. Visits are read by the table of these forms, and the
/// manual is made of it.
struct VisitForm {
  std::string_view verb;
  /// Words: X Y ID KEY NUMBER FILE.png FILE.json, in|out, @NAME for a name with its "@", and "seat"
  /// as it stands.
  std::string_view arguments;
  VisitCommand::Kind kind;
  std::string_view manual;
};
std::span<const VisitForm> visit_forms() noexcept;

/// A visit as it was written, in order of time, and everything that is wrong with it.
struct Visit {
  std::vector<VisitCommand> commands;
  std::vector<Diagnostic> mistakes;
};

/// Reads a visit (docent-visit(5)); `file` names it in mistakes. Defined for any text.
Visit parse_visit(std::string_view text, std::string_view file);

/// Reads a file; a file that cannot be read is a mistake like others.
Visit load_visit(const std::filesystem::path& file);

/// The key of a name in a visit: UP DOWN LEFT RIGHT ENTER BACK HELP VOLUME_UP VOLUME_DOWN, a
/// letter, a digit or F1...; Key::None where there is no such key.
input::InputEvent key_named(std::string_view name) noexcept;

}  // namespace docent::kiosk
