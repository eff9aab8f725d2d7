#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "platform/terminal/value.h"
#include "runtime/model/museum.h"

namespace docent::command {

// What the commands that question a database share. What can fail throws ContentError.

/// The index of the floor of that name, which came from this option of the command line; the
/// kiosk's floor where the name is empty.
std::uint32_t floor_named(const Museum& museum, std::string_view name,
                          std::string_view option = "--floor");

/// The exhibit of that id, which came from this option of the command line.
const Exhibit& exhibit_named(const Museum& museum, std::string_view id, std::string_view option);

/// X,Y of the command line.
inline Vec2 point_of(const std::array<double, 2>& given) {
  return {given[0], given[1]};
}

/// Rows of a CSV file whose columns are all numbers, with the words that they were written as, so
/// that an answer can repeat them.
struct NumberTable {
  std::vector<std::vector<double>> rows;
  std::vector<std::string> written;  ///< Per row, without the line end.
};

/// A column of a CSV file of numbers.
struct NumberColumn {
  std::string_view name;
  terminal::Limits limits{};
};

/// Reads the named columns, which must come first and in this order; more may follow and are
/// dropped. Their numbers are finite.
NumberTable read_numbers(const std::filesystem::path& file,
                         const std::vector<NumberColumn>& columns);

/// The polyline of a CSV file with the columns x,y: metres, floor frame, of some length and at most
/// 10 km.
std::vector<Vec2> read_path(const std::filesystem::path& file);

/// Writes text in the place of a file, whole or not at all.
void write_text(const std::filesystem::path& file, std::string_view text);

/// A double in as few digits as read back the same; `null` where it is not finite.
std::string json_number(double value);
/// [[x, y], ...].
std::string json_points(const std::vector<Vec2>& points);

}  // namespace docent::command
