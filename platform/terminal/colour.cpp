#include "platform/terminal/colour.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

namespace docent::terminal {
namespace {

/// What the environment says of a name; empty where it says nothing.
std::string_view environment(const char* name) noexcept {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets one
  return value == nullptr ? std::string_view() : std::string_view(value);
}

/// "Select Graphic Rendition" of ECMA-48, 8.3.117.
std::string_view sequence(Ink ink) noexcept {
  switch (ink) {
    case Ink::Error:
      return "\x1b[1;31m";
    case Ink::Warning:
      return "\x1b[1;33m";
    case Ink::Bold:
      break;
  }
  return "\x1b[1m";
}

}  // namespace

bool is_terminal(std::FILE* stream) noexcept {
  return ::isatty(::fileno(stream)) == 1;
}

ColourUse colour_use_of(std::FILE* stream) noexcept {
  const bool wanted = environment("NO_COLOR").empty() && environment("TERM") != "dumb";
  return wanted && is_terminal(stream) ? ColourUse::On : ColourUse::Off;
}

std::string painted(std::string_view text, Ink ink, ColourUse colour) {
  if (colour == ColourUse::Off) return std::string(text);
  return fmt::format("{}{}\x1b[0m", sequence(ink), text);
}

}  // namespace docent::terminal
