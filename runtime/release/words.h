#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The text form that manifests, states and health share: a line a fact, its words with one blank
/// between, the first says which fact. Safe on any bytes. Internal to release.
namespace docent::release {

/// Seconds since 1970, UTC.
using Time = std::int64_t;

/// The words of each line that has any.
std::vector<std::vector<std::string_view>> lines_of(std::string_view text);

/// A whole number of plain digits.
std::optional<std::uint64_t> number_of(std::string_view word);
/// "2026-11-23T15:00:00Z".
std::optional<Time> time_of(std::string_view word);
std::string text_of(Time time);

}  // namespace docent::release
