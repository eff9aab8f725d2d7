#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace docent::import {

/// How a CSV file is to be read; what is empty is found out.
struct CsvForm {
  std::string encoding{};  ///< "utf-8", "windows-1252", "utf-16"; empty: UTF-8, else told by a
                           ///< mark, else Windows-1252.
  char separator =
      '\0';  ///< `,`, `;`, tab or `|`; 0: the one that makes most columns of the header.
};

/// A row of the file: as many cells as there are columns, UTF-8, without blanks at their ends; line
/// ends within are LF.
struct CsvRecord {
  std::uint32_t line = 0;  ///< In which it begins, from 1; the header's is 1.
  std::vector<std::string> cell;
};

/// Something odd, with its line.
struct CsvDoubt {
  std::uint32_t line = 0;
  std::string message;  ///< A sentence.
  std::string hint{};
};

/// A spreadsheet (RFC 4180, and what spreadsheets make of it): the first row names the columns.
struct CsvTable {
  std::vector<std::string> column;
  std::vector<CsvRecord> record;  ///< Blank ones are left out.
  std::vector<CsvDoubt> doubts;
  std::string encoding;  ///< What it was read as: "UTF-8", "Windows-1252", "UTF-16".
  char separator = ',';
};

/// Reads any bytes. A text that is never closed ends where its line does, and is a doubt; so is a
/// row of too many cells. One of too few is filled up with empty ones.
CsvTable read_csv(std::string_view bytes, const CsvForm& form = {});

/// A cell as it is written, in quotation marks where it needs them.
std::string csv_cell(std::string_view text, char separator = ',');

}  // namespace docent::import
