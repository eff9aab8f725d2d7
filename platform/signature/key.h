#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/result.h"

namespace docent::signature {

/// The first bytes of the key's BLAKE2b-256: which key a signature is of, before it is verified.
using KeyId = std::array<std::byte, 8>;

/// Ed25519 (RFC 8032). Kiosks know it.
struct PublicKey {
  std::array<std::byte, 32> bytes{};
  bool operator==(const PublicKey&) const = default;
};

/// Whoever has it can put anything on the kiosks that know its public key.
struct SecretKey {
  std::array<std::byte, 32> seed{};
  bool operator==(const SecretKey&) const = default;
};

SecretKey make_key();
PublicKey public_key(const SecretKey& key);
KeyId id_of(const PublicKey& key);
/// As people compare it: 16 hexadecimal digits.
std::string name_of(const KeyId& id);

/// A key as the text of a file: a comment, then what it is and its bytes in base 64.
std::string to_text(const PublicKey& key);
std::string to_text(const SecretKey& key);

/// Reads such a text; lines that are empty or begin with '#' are skipped. Any bytes are safe.
/// `file` is only named in the sentence.
Result<PublicKey> parse_public_key(std::string_view text, const std::filesystem::path& file);
Result<SecretKey> parse_secret_key(std::string_view text, const std::filesystem::path& file);

Result<PublicKey> read_public_key(const std::filesystem::path& file);
Result<SecretKey> read_secret_key(const std::filesystem::path& file);
/// All of them, or the sentence about the first that cannot be read.
Result<std::vector<PublicKey>> read_public_keys(std::span<const std::filesystem::path> files);

}  // namespace docent::signature
