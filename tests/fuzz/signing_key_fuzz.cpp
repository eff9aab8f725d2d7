// Key files, signed texts and the signatures behind a database.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "platform/signature/key.h"
#include "platform/signature/signed_text.h"
#include "platform/sqlite/signature_block.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace docent;
  const std::string text(data, data + size);
  static const signature::PublicKey known = signature::public_key(signature::SecretKey{});
  if (const auto key = signature::parse_public_key(text, "fuzz"))
    if (signature::parse_public_key(signature::to_text(*key), "fuzz") != *key) __builtin_trap();
  if (const auto key = signature::parse_secret_key(text, "fuzz"))
    if (signature::parse_secret_key(signature::to_text(*key), "fuzz") != *key) __builtin_trap();
  // Nobody has this key, so nothing is signed with it but what the corpus holds.
  static_cast<void>(
      signature::read_signed_text(text, signature::Purpose::Release, {&known, 1}, "fuzz"));
  const auto block = std::as_bytes(std::span(data, size));
  if (const auto signatures = sqlite::decode_signatures(block); signatures && !signatures->empty())
    if (!std::ranges::equal(sqlite::encode_signatures(*signatures), block)) __builtin_trap();
  return 0;
}
