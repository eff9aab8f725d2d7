#include "content/command/query_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <span>
#include <sstream>

#include "content/content_error.h"
#include "content/read_source.h"
#include "content/write/replace_file.h"
#include "runtime/model/geometry/polyline.h"

namespace docent::command {
namespace {

using terminal::split;

constexpr double longest_path = 10'000;  // metres: two hours of walking

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::uint32_t column_of(std::string_view line, std::string_view part) {
  return static_cast<std::uint32_t>(part.data() - line.data()) + 1;
}

void check_header(std::string_view line, const std::string& file,
                  const std::vector<NumberColumn>& columns) {
  const auto names = split(line, ',');
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (i >= names.size() || trimmed(names[i]) != columns[i].name)
      throw content::ContentError(
          file, 1, i < names.size() ? column_of(line, names[i]) : 0, "csv-header",
          fmt::format("column {} should be '{}'", i + 1, columns[i].name),
          fmt::format("the first line should be {}",
                      fmt::join(columns | std::views::transform(&NumberColumn::name), ",")));
}

}  // namespace

std::uint32_t floor_named(const Museum& museum, std::string_view name, std::string_view option) {
  if (name.empty()) return museum.kiosk_floor < museum.floors.size() ? museum.kiosk_floor : 0;
  std::vector<std::string_view> names;
  for (std::uint32_t i = 0; i < museum.floors.size(); ++i) {
    names.push_back(museum.floors[i].plan.name);
    if (names.back() == name) return i;
  }
  throw content::ContentError(Errc::WrongUsage, std::string(option), "unknown-floor",
                              fmt::format("there is no floor '{}'", name),
                              fmt::format("the floors are: {}", fmt::join(names, ", ")));
}

const Exhibit& exhibit_named(const Museum& museum, std::string_view id, std::string_view option) {
  const auto found = std::ranges::find(museum.exhibits, id, &Exhibit::id);
  if (found == museum.exhibits.end())
    throw content::ContentError(Errc::WrongUsage, std::string(option), "unknown-exhibit",
                                fmt::format("there is no exhibit '{}'", id),
                                "`docent-content info DB --json` lists them");
  return *found;
}

NumberTable read_numbers(const std::filesystem::path& file,
                         const std::vector<NumberColumn>& columns) {
  std::istringstream in(content::read_text_source(file, "no-such-file"));
  std::string line;
  if (!std::getline(in, line)) line.clear();
  check_header(line, file.string(), columns);
  NumberTable table;
  for (std::uint32_t number = 2; std::getline(in, line); ++number) {
    if (trimmed(line).empty()) continue;
    const auto parts = split(line, ',');
    std::vector<double> row;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i >= parts.size())
        throw content::ContentError(
            file.string(), number, 0, "csv-row",
            fmt::format("the row has {} columns of {}", parts.size(), columns.size()));
      const auto value = terminal::read_number(trimmed(parts[i]), columns[i].limits);
      if (!value)
        throw content::ContentError(file.string(), number, column_of(line, parts[i]), "csv-number",
                                    value.error());
      row.push_back(*value);
    }
    const std::string_view last = trimmed(parts[columns.size() - 1]);
    table.written.emplace_back(std::string_view(line).substr(
        0, static_cast<std::size_t>(last.data() + last.size() - line.data())));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<Vec2> read_path(const std::filesystem::path& file) {
  std::vector<Vec2> path;
  for (const auto& row : read_numbers(file, {{"x"}, {"y"}}).rows) path.emplace_back(row[0], row[1]);
  const double length = polyline_length(path);
  if (!(length > 0))
    throw content::ContentError(file.string(), 0, 0, "no-path",
                                "a path needs two different points");
  if (length > longest_path)
    throw content::ContentError(
        file.string(), 0, 0, "long-path",
        fmt::format("the path is {:.4g} m long, and walks are made of at most {:.0f} m", length,
                    longest_path),
        "coordinates are metres in the floor frame; walk a longer path in pieces");
  return path;
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  write::replace_file(file, std::as_bytes(std::span(text)));
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string json_points(const std::vector<Vec2>& points) {
  std::string text = "[";
  for (const Vec2 point : points)
    text += fmt::format("{}[{}, {}]", text.size() > 1 ? ", " : "", json_number(point.x),
                        json_number(point.y));
  return text + "]";
}

}  // namespace docent::command
