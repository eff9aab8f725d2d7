#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "runtime/interface/control.h"
#include "runtime/interface/sheet.h"

namespace docent::interface {

/// Whose controls are asked for.
struct ControlRequest {
  const Museum& museum;
  const InterfaceState& state;
  std::uint32_t per_page = 1;  ///< Exhibits on a page of the list.
};

/// A word of the interface in every language that has it.
LocalText word_in_all(const Museum& museum, std::string_view key);
/// A control whose label is a word of the interface.
Control button(const Museum& museum, std::string name, std::string_view key, Action action);
/// An exhibit, on the model or in a list.
Control exhibit_control(const Museum& museum, std::uint32_t exhibit, Role role,
                        const InterfaceState& state);
/// A tour: it begins with its first exhibit.
Control tour_control(const Museum& museum, std::uint32_t index, Role role,
                     const InterfaceState& state);
/// What the welcome offers besides beginning: some of what is most worth seeing, and tours for who
/// has so much time. Nothing where a list has room for few rows.
void add_offers(const ControlRequest& request, std::vector<Control>& out);
/// What helps on every screen: the nearest toilets, and the list of places; and, where a way is
/// chosen, ways without steps or escalators, if the building has any.
void add_helps(const ControlRequest& request, std::vector<Control>& out);

/// The keys of the language, of letters or of digits, and those that change what was typed.
void add_keys(const ControlRequest& request, std::vector<Control>& out);

/// How a screen is shown: what can be pressed, in focus order, and where everything lies in the
/// content of a panel or a card.
struct Face {
  void (*add_controls)(const ControlRequest& request, std::vector<Control>& out);
  void (*lay_out)(Sheet& sheet, const PixelBox& content);
};
/// A screen has two faces: on the glass of one visitor and on the card of a seat. A further screen
/// is a row of `screens`.
struct ScreenFaces {
  Screen screen;
  Face whole, card;
};
extern const std::array<ScreenFaces, 6> screens;

inline const ScreenFaces& faces_of(Screen screen) noexcept {
  return screens[static_cast<std::size_t>(screen)];
}

}  // namespace docent::interface
