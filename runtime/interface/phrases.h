#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/model/museum.h"

namespace docent::interface {

/// `text` with every "{name}" replaced by `value`.
std::string filled_in(std::string_view text, std::string_view name, std::string_view value);

/// A whole number in the digits of a language.
std::string number_in(const Museum& museum, std::uint32_t language, long number);

/// "42 m" in a language: whole metres, at least 1.
std::string distance_in(const Museum& museum, std::uint32_t language, double metres);

/// "about a minute": rounded so that nobody waits longer than promised, with the plural forms that
/// the languages of the world distinguish for such numbers (one, two, few, many).
std::string time_in(const Museum& museum, std::uint32_t language, double seconds);

}  // namespace docent::interface
