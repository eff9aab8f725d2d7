#pragma once

#include <sodium/crypto_generichash.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "runtime/model/result.h"

namespace docent::signature {

/// BLAKE2b-256 (RFC 7693) of bytes that come part by part.
class Digest {
 public:
  Digest() noexcept;
  void add(std::span<const std::byte> bytes) noexcept;
  /// 64 hexadecimal digits. Once.
  std::string finish();

 private:
  crypto_generichash_state state_;
};

/// That of a file.
Result<std::string> digest_of(const std::filesystem::path& file);

}  // namespace docent::signature
