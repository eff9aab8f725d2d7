#include "runtime/kiosk/daily_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace docent::kiosk {
namespace {

constexpr std::array<std::pair<CountedCell::Kind, std::string_view>, 3> kinds{
    {{CountedCell::Kind::Exhibit, "exhibit"},
     {CountedCell::Kind::Route, "route"},
     {CountedCell::Kind::Language, "language"}}};

/// Takes the text up to `end` from the front, and `end` with it; all of it where there is none.
std::string_view take_until(std::string_view& text, char end) {
  const std::string_view taken = text.substr(0, std::min(text.find(end), text.size()));
  text.remove_prefix(std::min(taken.size() + 1, text.size()));
  return taken;
}

std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Ids and tags have neither; a museum whose names have them keeps a CSV that can be read.
bool fits_a_csv(std::string_view name) {
  return !name.empty() && name.find_first_of(",\n\r\"") == std::string_view::npos;
}

bool add_line(std::string_view line, DailyCounts& counts) {
  const std::string_view day = take_until(line, ',');
  const std::string_view kind = take_until(line, ',');
  const std::string_view name = take_until(line, ',');
  const std::optional<std::uint64_t> count = number(line);
  if (!count || day.empty() || (!counts.day.empty() && day != counts.day)) return false;
  counts.day = day;
  if (kind == "touches" && name.empty()) {
    counts.touches += *count;
    return true;
  }
  const auto known = std::ranges::find(kinds, kind, &decltype(kinds)::value_type::second);
  if (known == kinds.end() || !fits_a_csv(name)) return false;
  counts.visits[{known->first, std::string(name)}] += *count;
  return true;
}

std::string lines_of(std::string_view day, const CellCounts& cells) {
  std::string lines;
  for (const auto& [cell, count] : cells)
    if (fits_a_csv(cell.name))
      lines += fmt::format("{},{},{},{}\n", day, to_string(cell.kind), cell.name, count);
  return lines;
}

std::size_t index(CountedCell::Kind kind) {
  return static_cast<std::size_t>(kind);
}

/// Of the cells of each kind: all together, and the largest.
struct Sums {
  struct OfKind {
    std::uint64_t sum = 0, largest = 0;
  };
  std::array<OfKind, kinds.size()> of{};
};

Sums sums_of(const CellCounts& cells) {
  Sums sums;
  for (const auto& [cell, count] : cells) {
    auto& [sum, largest] = sums.of[index(cell.kind)];
    sum += count;
    largest = std::max(largest, count);
  }
  return sums;
}

/// Kinds of cells know of each other: every visit has a language, every visit that was led asked
/// for an exhibit, and every one that did was led. Where a cell of one kind holds more visits than
/// the cells told of another do, the rest are in the small ones: that would tell of those.
bool would_tell_of_others(const Sums& sums) {
  const auto& exhibits = sums.of[index(CountedCell::Kind::Exhibit)];
  const auto& routes = sums.of[index(CountedCell::Kind::Route)];
  const auto& languages = sums.of[index(CountedCell::Kind::Language)];
  return std::max(exhibits.largest, routes.largest) > languages.sum ||
         exhibits.largest > routes.sum || routes.largest > exhibits.sum;
}

}  // namespace

std::string_view to_string(CountedCell::Kind kind) noexcept {
  return kinds[index(kind)].second;
}

DailyCounts& operator+=(DailyCounts& counts, const DailyCounts& more) {
  counts.touches += more.touches;
  for (const auto& [cell, count] : more.visits) counts.visits[cell] += count;
  return counts;
}

PublishedCounts published(const DailyCounts& counts) {
  PublishedCounts told{.day = counts.day, .visits = 0, .touches = 0, .cells = {}};
  for (const auto& [cell, count] : counts.visits)
    if (count >= least_published) told.cells[cell] = count;
  const Sums sums = sums_of(told.cells);
  told.visits = sums.of[index(CountedCell::Kind::Language)].sum;
  if (told.visits >= least_published && counts.touches >= least_published)
    told.touches = counts.touches;
  if (would_tell_of_others(sums))
    std::erase_if(told.cells,
                  [](const auto& cell) { return cell.first.kind != CountedCell::Kind::Language; });
  return told;
}

std::string to_csv(const PublishedCounts& counts) {
  std::string lines;
  if (counts.visits > 0) lines += fmt::format("{},visits,,{}\n", counts.day, counts.visits);
  if (counts.touches > 0) lines += fmt::format("{},touches,,{}\n", counts.day, counts.touches);
  return lines + lines_of(counts.day, counts.cells);
}

std::string to_text(const DailyCounts& counts) {
  return fmt::format("{}{},touches,,{}\n{}", counts_header, counts.day, counts.touches,
                     lines_of(counts.day, counts.visits));
}

std::optional<DailyCounts> daily_counts_from(std::string_view text) {
  if (!text.starts_with(counts_header)) return std::nullopt;
  text.remove_prefix(counts_header.size());
  DailyCounts counts;
  while (!text.empty())
    if (!add_line(take_until(text, '\n'), counts)) return std::nullopt;
  if (counts.day.empty()) return std::nullopt;
  return counts;
}

}  // namespace docent::kiosk
