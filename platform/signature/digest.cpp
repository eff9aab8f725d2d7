#include "platform/signature/digest.h"

#include <fmt/format.h>

#include <array>

#include "platform/file/read_file.h"

namespace docent::signature {

Digest::Digest() noexcept {
  crypto_generichash_init(&state_, nullptr, 0, crypto_generichash_BYTES);
}

void Digest::add(std::span<const std::byte> bytes) noexcept {
  crypto_generichash_update(&state_, reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size());
}

std::string Digest::finish() {
  std::array<unsigned char, crypto_generichash_BYTES> sum{};
  crypto_generichash_final(&state_, sum.data(), sum.size());
  std::string digits;
  for (const unsigned char byte : sum) digits += fmt::format("{:02x}", byte);
  return digits;
}

Result<std::string> digest_of(const std::filesystem::path& file) {
  const Result<std::string> bytes = file::read_file(file);
  if (!bytes) return std::unexpected(bytes.error());
  Digest digest;
  digest.add(std::as_bytes(std::span(*bytes)));
  return digest.finish();
}

}  // namespace docent::signature
