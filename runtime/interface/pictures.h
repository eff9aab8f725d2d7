#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "runtime/interface/control.h"

namespace docent::interface {

/// One of an exhibit's pictures, and what is said of it. Borrows from the museum.
struct ShownPicture {
  std::uint32_t image = 0;            ///< Index into Museum::images.
  std::size_t number = 1, count = 1;  ///< Which it is of how many, from 1.
  std::optional<std::uint32_t>
      further{};                       ///< Index into Museum::pictures; none: the exhibit's own.
  const LocalText* caption = nullptr;  ///< Null: none.
  const LocalText* description = nullptr;  ///< Never null.
};

/// That which a visitor in this state sees of an exhibit: the first, until they leaf on.
ShownPicture shown_picture(const Museum& museum, const InterfaceState& state,
                           std::uint32_t exhibit) noexcept;

/// Have staff given it any picture? Nothing takes the place of none.
bool is_pictured(const Museum& museum, std::uint32_t exhibit) noexcept;

/// How many there are to leaf through; at least 1.
std::size_t picture_count(const Museum& museum, std::uint32_t exhibit) noexcept;

/// The image that is a video and is seen by a visitor who stands before its exhibit, on a glass of
/// their own or on a card.
std::optional<std::uint32_t> shown_video(const Museum& museum,
                                         const InterfaceState& state) noexcept;

/// The sound, an index into Museum::sounds, that a visitor in this state listens to; on a shared
/// glass nobody does.
std::optional<std::uint32_t> shown_sound(const Museum& museum,
                                         const InterfaceState& state) noexcept;
/// May they listen to what there is at the exhibit that they stand before?
bool can_listen(const Museum& museum, const InterfaceState& state) noexcept;

/// Does the visitor read the longer text of the exhibit that they are at?
bool reads_more(const Museum& museum, const InterfaceState& state) noexcept;

}  // namespace docent::interface
