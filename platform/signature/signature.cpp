#include "platform/signature/signature.h"

#include <fmt/format.h>
#include <sodium/crypto_sign_ed25519.h>
#include <sodium/utils.h>

#include <algorithm>
#include <array>

namespace docent::signature {
namespace {

static_assert(crypto_sign_ed25519_BYTES == 64);

constexpr std::array<std::string_view, 2> domains{"docent museum database v1",
                                                  "docent release manifest v1"};

const unsigned char* message_bytes(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}

/// The message behind its purpose and a zero, which no purpose holds.
std::vector<std::byte> signed_bytes(Purpose purpose, std::span<const std::byte> message) {
  const std::string_view domain = domains[static_cast<std::size_t>(purpose)];
  const auto text = std::as_bytes(std::span(domain));
  std::vector<std::byte> bytes(text.begin(), text.end());
  bytes.push_back(std::byte{0});
  bytes.insert(bytes.end(), message.begin(), message.end());
  return bytes;
}

std::string names_of(auto&& keys, auto&& id) {
  std::vector<std::string> names;
  for (const auto& key : keys) names.push_back(name_of(id(key)));
  return fmt::format("{}", fmt::join(names, " and "));
}

}  // namespace

Signature sign(Purpose purpose, std::span<const std::byte> message, const SecretKey& key) {
  Signature signature{.key = id_of(public_key(key))};
  std::array<unsigned char, crypto_sign_ed25519_PUBLICKEYBYTES> known{};
  std::array<unsigned char, crypto_sign_ed25519_SECRETKEYBYTES> both{};
  crypto_sign_ed25519_seed_keypair(known.data(), both.data(), message_bytes(key.seed.data()));
  const std::vector<std::byte> bytes = signed_bytes(purpose, message);
  crypto_sign_ed25519_detached(reinterpret_cast<unsigned char*>(signature.bytes.data()), nullptr,
                               message_bytes(bytes.data()), bytes.size(), both.data());
  sodium_memzero(both.data(), both.size());
  return signature;
}

bool is_signed(Purpose purpose, std::span<const std::byte> message,
               std::span<const Signature> signatures, std::span<const PublicKey> keys) {
  const std::vector<std::byte> bytes = signed_bytes(purpose, message);
  const auto is_right = [&](const Signature& signature, const PublicKey& key) {
    return signature.key == id_of(key) &&
           crypto_sign_ed25519_verify_detached(message_bytes(signature.bytes.data()),
                                               message_bytes(bytes.data()), bytes.size(),
                                               message_bytes(key.bytes.data())) == 0;
  };
  return std::ranges::any_of(signatures, [&](const Signature& signature) {
    return std::ranges::any_of(keys,
                               [&](const PublicKey& key) { return is_right(signature, key); });
  });
}

std::string why_not_signed(std::span<const Signature> signatures, std::span<const PublicKey> keys) {
  if (signatures.empty()) return "is not signed";
  const bool is_known = std::ranges::any_of(signatures, [&](const Signature& signature) {
    return std::ranges::any_of(keys,
                               [&](const PublicKey& key) { return id_of(key) == signature.key; });
  });
  if (is_known) return "has a wrong signature";
  return fmt::format("is signed with another key ({}, and known here is {})",
                     names_of(signatures, [](const Signature& s) { return s.key; }),
                     names_of(keys, id_of));
}

void put(const Signature& signature, std::vector<Signature>& signatures) {
  const auto same = std::ranges::find(signatures, signature.key, &Signature::key);
  if (same == signatures.end())
    signatures.push_back(signature);
  else
    *same = signature;
}

}  // namespace docent::signature
