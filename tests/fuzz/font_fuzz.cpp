#include <cstddef>
#include <cstdint>
#include <span>

#include "content/content_error.h"
#include "content/import/font/read_font.h"

/// A font of anybody's, to the outlines of its letters.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const docent::import::Font font =
        docent::import::read_font(std::as_bytes(std::span(data, size)));
    if (font.family.empty()) __builtin_trap();
  } catch (const docent::content::ContentError& error) {
    if (error.code != "unreadable-font" || error.hint.empty()) __builtin_trap();
  }
  return 0;
}
