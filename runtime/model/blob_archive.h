#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace docent {

/// Where the bytes of a museum lie that are too many to be kept in memory and are seldom asked for:
/// its sounds, its pictures.
class BlobArchive {
 public:
  BlobArchive() = default;
  BlobArchive(const BlobArchive&) = delete;
  BlobArchive& operator=(const BlobArchive&) = delete;
  virtual ~BlobArchive() = default;

  /// Valid until the next call; nothing where it cannot be read. May wait for a disk. One thread.
  virtual std::span<const std::byte> read(std::uint32_t number) = 0;
  /// Fills `out` with the bytes of it that begin at `from`; false where it does not have them. What
  /// was read whole is no longer valid.
  virtual bool read_part(std::uint32_t number, std::size_t from, std::span<std::byte> out) = 0;
  /// Whoever has what they wanted gives its memory back.
  virtual void let_go() noexcept = 0;
};

}  // namespace docent
