#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/diagnostic.h"

namespace docent::config {

/// Where something stands in a text file. Lines and columns count from 1; columns count characters.
struct SourceRange {
  std::uint32_t line = 1, column = 1;
  std::uint32_t length = 1;  ///< Characters, up to the end of the first line.

  friend bool operator==(const SourceRange&, const SourceRange&) = default;
};

struct TomlEntry;

/// A value of a TOML file with its place. Only the member for its kind holds something. Keeps
/// toml++ out of everyone else's headers.
struct TomlNode {
  enum class Kind : std::uint8_t { Table, Array, Text, Integer, Number, Boolean, Date };
  Kind kind = Kind::Table;
  SourceRange range;
  std::string text;          ///< Of a Text.
  std::int64_t integer = 0;  ///< Of an Integer.
  double number = 0;         ///< Of an Integer or a Number.
  bool boolean = false;      ///< Of a Boolean.
  /// Of a Date with a day: that, and the time of it, if it says one. What says from where on Earth
  /// it counts (a Z, an offset) has none.
  std::optional<std::chrono::local_seconds> date;
  bool has_time = false;           ///< Of such a date.
  std::vector<TomlNode> items;     ///< Of an Array.
  std::vector<TomlEntry> entries;  ///< Of a Table, in the order of the file.
};

struct TomlEntry {
  std::string key;
  SourceRange key_range;
  TomlNode value;
};

/// What the kind is called in a sentence: "a text", "a table".
std::string_view name_of(TomlNode::Kind kind) noexcept;

/// A TOML file, or what is wrong with it.
struct TomlFile {
  std::optional<TomlNode> root;           ///< A table. Empty where the file could not be read.
  std::vector<Diagnostic> diagnostics{};  ///< `missing-file` or `unreadable-toml`.
};

/// Bytes. No file that people write is larger: a larger one is the wrong one.
inline constexpr std::size_t largest_toml = std::size_t{64} << 20U;

/// Reads a TOML file. `name` is what diagnostics call it.
TomlFile read_toml(const std::filesystem::path& file, const std::string& name);

/// The same for text in memory.
TomlFile parse_toml(std::string_view text, const std::string& name);

}  // namespace docent::config
