#include "platform/sqlite/signature_block.h"

#include <fmt/core.h>
#include <sodium/crypto_generichash.h>

#include <algorithm>
#include <string_view>

namespace docent::sqlite {
namespace {

using signature::Signature;

constexpr std::string_view block_magic = "docent signed v1";
constexpr std::size_t sum_size = 16;
constexpr std::size_t entry_size = sizeof(signature::KeyId) + 64;

std::array<std::byte, sum_size> sum_of(std::span<const std::byte> bytes) {
  std::array<std::byte, sum_size> sum{};
  crypto_generichash(reinterpret_cast<unsigned char*>(sum.data()), sum.size(),
                     reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), nullptr,
                     0);
  return sum;
}

void append(std::vector<std::byte>& bytes, std::span<const std::byte> more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace

std::vector<std::byte> encode_signatures(std::span<const Signature> signatures) {
  std::vector<std::byte> block;
  append(block, std::as_bytes(std::span(block_magic)));
  block.push_back(static_cast<std::byte>(signatures.size()));
  for (const Signature& each : signatures) {
    append(block, each.key);
    append(block, each.bytes);
  }
  append(block, sum_of(block));
  return block;
}

std::optional<std::vector<Signature>> decode_signatures(std::span<const std::byte> block) {
  std::vector<Signature> signatures;
  if (block.empty()) return signatures;
  constexpr std::size_t head = block_magic.size() + 1;
  if (block.size() < head + entry_size + sum_size) return std::nullopt;
  if (!std::ranges::equal(block.first(block_magic.size()), std::as_bytes(std::span(block_magic))))
    return std::nullopt;
  const auto count = std::to_integer<std::size_t>(block[block_magic.size()]);
  const std::size_t size = head + count * entry_size;
  if (count < 1 || count > most_signatures || block.size() != size + sum_size) return std::nullopt;
  if (!std::ranges::equal(block.subspan(size), sum_of(block.first(size)))) return std::nullopt;
  for (std::size_t i = 0; i < count; ++i) {
    const auto entry = block.subspan(head + i * entry_size, entry_size);
    Signature& read = signatures.emplace_back();
    std::ranges::copy(entry.first(read.key.size()), read.key.begin());
    std::ranges::copy(entry.subspan(read.key.size()), read.bytes.begin());
  }
  return signatures;
}

Result<void> check_signature(const Database& database, const std::filesystem::path& file,
                             std::span<const signature::PublicKey> keys) {
  if (signature::is_signed(signature::Purpose::Database, database.checksum, database.signatures,
                           keys))
    return {};
  return std::unexpected(
      Error{Errc::InvalidInput,
            fmt::format("{}: {}; 'docent-content sign' with the museum's own key signs it",
                        file.string(), signature::why_not_signed(database.signatures, keys))});
}

Result<std::vector<std::byte>> signed_file(const Database& database,
                                           const std::filesystem::path& file,
                                           const signature::SecretKey& key) {
  std::vector<Signature> signatures = database.signatures;
  signature::put(signature::sign(signature::Purpose::Database, database.checksum, key), signatures);
  if (signatures.size() > most_signatures)
    return std::unexpected(
        Error{Errc::InvalidInput,
              fmt::format("{}: holds {} signatures already; compile it again and sign that",
                          file.string(), most_signatures)});
  std::vector<std::byte> bytes = database.bytes;
  append(bytes, encode_signatures(signatures));
  return bytes;
}

}  // namespace docent::sqlite
