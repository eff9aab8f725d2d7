#include "platform/pin/pin.h"

#include <sodium/core.h>
#include <sodium/crypto_pwhash.h>

#include <algorithm>
#include <array>

namespace docent::pin {
namespace {

/// A PIN has few figures, so what it costs to try one is what protects it: three passes over 16 MB,
/// a tenth of a second on a small fanless machine, and no more memory than it can spare while it
/// draws.
constexpr unsigned long long passes = 3;
constexpr std::size_t memory = std::size_t{16} << 20U;

}  // namespace

bool is_pin(std::string_view text) noexcept {
  return text.size() >= least_figures && text.size() <= most_figures &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

Result<std::string> hash(std::string_view pin) {
  if (!is_pin(pin))
    return std::unexpected(
        Error{Errc::InvalidInput, "a PIN is 4 to 12 figures, as they are on the pad"});
  std::array<char, crypto_pwhash_STRBYTES> out{};
  if (sodium_init() < 0 ||
      crypto_pwhash_str(out.data(), pin.data(), pin.size(), passes, memory) != 0)
    return std::unexpected(
        Error{Errc::Environment, "the PIN cannot be hashed: 16 MB of memory are needed for it"});
  return std::string(out.data());
}

bool matches(std::string_view pin, const std::string& hash) noexcept {
  if (sodium_init() < 0 || hash.size() >= crypto_pwhash_STRBYTES) return false;
  return crypto_pwhash_str_verify(hash.c_str(), pin.data(), pin.size()) == 0;
}

}  // namespace docent::pin
