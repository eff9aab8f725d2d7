#pragma once

namespace docent::config {

/// Has a kiosk a font with this letter? Those are Debian 12's packages fonts-inter, fonts-noto-cjk
/// and fonts-noto-core, which the kiosk's package depends on. Line breaks and tabs are none.
bool is_shown(char32_t letter) noexcept;

}  // namespace docent::config
