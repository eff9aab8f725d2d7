#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace docent::config {

/// Where frames may go.
enum class DisplayKind : std::uint8_t { Auto, Kms, Window, Headless };

/// Their names, on the command line and in kiosk.toml. A further one is a row here and an opener in
/// `runtime/kiosk/edges.cpp`.
inline constexpr std::array<std::pair<std::string_view, DisplayKind>, 4> display_kinds{
    {{"auto", DisplayKind::Auto},
     {"kms", DisplayKind::Kms},
     {"window", DisplayKind::Window},
     {"headless", DisplayKind::Headless}}};

}  // namespace docent::config
