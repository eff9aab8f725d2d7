#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/interface/seats.h"
#include "runtime/kiosk/visit.h"

using namespace docent;

namespace {

bool is_playable(const kiosk::VisitCommand& command, std::size_t lines) {
  using Kind = kiosk::VisitCommand::Kind;
  if (!std::isfinite(command.time) || command.time < 0) return false;
  if (command.line < 1 || command.line > lines) return false;
  if (command.seat && (*command.seat < 1 || *command.seat > interface::most_seats)) return false;
  const auto on_screen = [](float place) { return place >= 0 && place <= 1; };
  switch (command.kind) {
    case Kind::Tap:
    case Kind::Down:
    case Kind::Move:
      return on_screen(command.contact.x) && on_screen(command.contact.y);
    case Kind::Press:
      return command.key.key != input::Key::None;
    default:
      return true;
  }
}

}  // namespace

/// Whatever a visit's text is, its commands can be played in order, and a mistake names its line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
  const kiosk::Visit visit = kiosk::parse_visit(text, "fuzz.visit");
  if (!std::ranges::is_sorted(visit.commands, {}, &kiosk::VisitCommand::time)) __builtin_trap();
  for (const kiosk::VisitCommand& command : visit.commands)
    if (!is_playable(command, lines)) __builtin_trap();
  for (const Diagnostic& mistake : visit.mistakes)
    if (mistake.line < 1 || mistake.line > lines || mistake.message.empty()) __builtin_trap();
  return 0;
}
