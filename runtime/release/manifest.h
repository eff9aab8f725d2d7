#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/result.h"
#include "runtime/release/words.h"

namespace docent::release {

/// What a release's manifest is called in its folder or below its URL.
inline constexpr std::string_view manifest_name = "release.txt";
/// No manifest is larger: what is fetched under its name ends here.
inline constexpr std::size_t largest_manifest = 16384;

/// A database of a release, for the programs of one schema version.
struct ReleasedFile {
  std::uint32_t schema = 0;
  std::uint64_t size = 0;  ///< Bytes.
  std::string hash{};      ///< BLAKE2b-256, 64 hexadecimal digits.
  std::string name{};      ///< In the release's folder: letters, digits, '.', '-' and '_'.
  bool operator==(const ReleasedFile&) const = default;
};

/// Spreads a release over time: a device takes it when the share of the time that has gone by has
/// passed the device's own number.
struct Rollout {
  Time start = 0;
  std::uint64_t hours = 0;  ///< 0: everybody at once.
  bool operator==(const Rollout&) const = default;
};

/// What a release holds and for whom. Versions of one museum only rise.
///
///   docent release 1
///   version 42
///   issued 2026-11-23T15:00:00Z
///   expires 2026-12-23T15:00:00Z
///   program 0.1.0                              the oldest program that may take it; may be missing
///   group foyer                                any number; none is everybody
///   rollout 2026-11-23T16:00:00Z 24            may be missing
///   halted 41                                  any number: releases that nobody shall show
///   file 7 18201600 HASH museum-7-HASH.db      at least one
struct Manifest {
  std::uint64_t version = 0;  ///< At least 1.
  Time issued = 0, expires = 0;
  std::string program{};
  std::vector<std::string> groups{};
  Rollout rollout{};
  std::vector<std::uint64_t> halted{};
  std::vector<ReleasedFile> files{};  ///< One a schema version.
  bool operator==(const Manifest&) const = default;
};

std::string to_text(const Manifest& manifest);
/// Safe on any bytes. `where` is only named in the sentence.
Result<Manifest> parse_manifest(std::string_view text, const std::string& where);

/// The file for a schema version; null where there is none.
const ReleasedFile* file_for(const Manifest& manifest, std::uint32_t schema);

/// Is it one that may lie in a release: not hidden, no path?
bool is_file_name(std::string_view name);
bool is_group_name(std::string_view name);

}  // namespace docent::release
