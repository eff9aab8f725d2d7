#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "platform/signature/signature.h"
#include "platform/sqlite/database.h"
#include "runtime/model/result.h"

/// The signatures of a database, which lie behind its last page, where SQLite does not look: a
/// signed database is the unsigned one, byte for byte, and a block after it. Its checksum covers
/// the pages; what is signed is the checksum.
///
///   16 bytes   "docent signed v1"
///   byte       how many signatures, 1 to 4
///   each       8 bytes: the key's id; 64 bytes: Ed25519
///   16 bytes   BLAKE2b-128 of the block so far
namespace docent::sqlite {

inline constexpr std::size_t most_signatures = 4;

/// The block; at most most_signatures.
std::vector<std::byte> encode_signatures(std::span<const signature::Signature> signatures);

/// The signatures of a block that is exactly that; nothing where the bytes are none. No bytes at
/// all are no signatures. Safe on any bytes.
std::optional<std::vector<signature::Signature>> decode_signatures(
    std::span<const std::byte> block);

/// Is the database signed with one of the keys? InvalidInput, with a sentence, where it is not.
/// `file` is only named in it.
Result<void> check_signature(const Database& database, const std::filesystem::path& file,
                             std::span<const signature::PublicKey> keys);

/// The bytes of the database's file with a signature by this key: added, or in the place of its
/// own. InvalidInput where there are as many as fit already.
Result<std::vector<std::byte>> signed_file(const Database& database,
                                           const std::filesystem::path& file,
                                           const signature::SecretKey& key);

}  // namespace docent::sqlite
