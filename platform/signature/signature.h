#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platform/signature/key.h"

namespace docent::signature {

/// What a signature vouches for. It is part of what is signed, so that one is never taken for the
/// other.
enum class Purpose : std::uint8_t {
  Database,  ///< The checksum of a museum's database.
  Release,   ///< The manifest of a release.
};

/// Ed25519 of a message, by one key.
struct Signature {
  KeyId key{};
  std::array<std::byte, 64> bytes{};
  bool operator==(const Signature&) const = default;
};

/// The same message and key always give the same signature.
Signature sign(Purpose purpose, std::span<const std::byte> message, const SecretKey& key);

/// Is one of the signatures a right one of one of the keys?
bool is_signed(Purpose purpose, std::span<const std::byte> message,
               std::span<const Signature> signatures, std::span<const PublicKey> keys);

/// Why is_signed said no, for an operator: "is not signed", "is signed with another key (ID), and
/// only ID is known here", "has a wrong signature".
std::string why_not_signed(std::span<const Signature> signatures, std::span<const PublicKey> keys);

/// Puts a signature among others: in the place of the one by the same key, else at the end.
void put(const Signature& signature, std::vector<Signature>& signatures);

}  // namespace docent::signature
