#pragma once

#include <cstdint>

#include "runtime/input/key_decoder.h"

namespace docent::x11 {

/// The kiosk's key behind an X11 keysym; Key::None for one it does not use.
input::KeyName key_of_keysym(std::uint32_t keysym) noexcept;

}  // namespace docent::x11
