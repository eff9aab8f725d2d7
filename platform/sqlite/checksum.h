#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace docent::sqlite {

/// BLAKE2b-256, as row 0 of table `checksum` holds it.
using Checksum = std::array<std::byte, 32>;

/// The checksum of a database file that holds its checksum at byte `place`: of all bytes, with
/// those 32 taken as zero. So every byte of the file is covered; the checksum's own are when they
/// are compared. `place` + 32 must lie within the file.
Checksum checksum_of(std::span<const std::byte> file, std::size_t place);

/// Where the value lies in the file; empty unless it does exactly once.
std::optional<std::size_t> place_of(std::span<const std::byte> file, const Checksum& value);

}  // namespace docent::sqlite
