#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/toml_document.h"
#include "runtime/model/diagnostic.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::config {

/// A file's index in the list of the files that were read.
enum class FileIndex : std::uint32_t {};

/// Where a value was written.
struct Place {
  FileIndex file{};
  SourceRange range;
};

/// A value with the place where people wrote it, so that whoever finds it wrong later can say
/// where.
template <typename T>
struct Located {
  T value{};
  Place place;         ///< Where it was not given: the section that could have held it.
  bool given = false;  ///< False: `value` is the default.
  SourceRange key{};   ///< Where its key was written, in the same file; line 0 where it has none.
};

/// Texts by language or by key.
using LocatedTexts = std::map<std::string, Located<std::string>, std::less<>>;

/// Texts in a list, each with its place.
using LocatedList = std::vector<Located<std::string>>;

/// Numbers in a list, each with its place.
using LocatedNumbers = std::vector<Located<double>>;

/// One point or several.
using LocatedPoints = std::vector<Located<Vec2>>;

/// Half a section of something round: radius and height, metres, each point with its place.
struct Outline {
  LocatedPoints points;
};

/// The values from `least` to `most`, both included.
struct Range {
  double least = 0, most = 0;
};

/// How wide a thing is across its front, and how deep. Metres.
struct Size {
  double across = 0, deep = 0;
};

/// What was read, where there is something, and everything that is wrong with it, in the order of
/// the files. Without an error among the diagnostics the value is complete.
template <typename T>
struct Loaded {
  std::optional<T> value;
  std::vector<Diagnostic> diagnostics;
};

}  // namespace docent::config
