#include "content/import/collection/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "content/import/collection/plain_text.h"
#include "tests/support/reference_data.h"
#include "tests/support/run_program.h"

namespace docent::import::csv_test {
namespace {

using testing::ElementsAre;

TEST(Csv, ReadsQuotedSeparatorsMarksAndLineEnds) {
  const CsvTable table = read_csv("id,title\r\n1,\"a, \"\"b\"\"\r\nc\"\r\n2,d\r\n");

  ASSERT_EQ(table.record.size(), 2U);
  EXPECT_THAT(table.record[0].cell, ElementsAre("1", "a, \"b\"\nc"));
  EXPECT_EQ(table.record[0].line, 2U);
  EXPECT_EQ(table.record[1].line, 4U);
  EXPECT_TRUE(table.doubts.empty());
}

TEST(Csv, FindsOutTheSeparator) {
  EXPECT_EQ(read_csv("a;b;c\n1;2,5;3\n").separator, ';');
  EXPECT_EQ(read_csv("a\tb\n").separator, '\t');
  EXPECT_THAT(read_csv("a,b;c\n1,2;3\n", {.separator = ';'}).column, ElementsAre("a,b", "c"));
}

TEST(Csv, ReadsWhatSpreadsheetsOfWindowsWrite) {
  const CsvTable old = read_csv(
      "Titel\r\nM\xe4"
      "dchen \x96 1.200 \x80\r\n");
  const CsvTable wide = read_csv(std::string_view("\xff\xfeT\0\n\0\xfc\0\n\0", 10));

  EXPECT_EQ(old.encoding, "Windows-1252");
  EXPECT_EQ(old.record.at(0).cell.at(0), "Mädchen – 1.200 €");
  EXPECT_EQ(wide.encoding, "UTF-16");
  EXPECT_EQ(wide.record.at(0).cell.at(0), "ü");
}

TEST(Csv, TheFirstColumnIsNotTheByteOrderMark) {
  EXPECT_EQ(read_csv("\xEF\xBB\xBFid,title\n").column.at(0), "id");
}

TEST(Csv, SaysWhereATextIsNeverClosed) {
  const CsvTable table = read_csv("a,b\n1,\"open\n2,c\n");

  ASSERT_EQ(table.doubts.size(), 1U);
  EXPECT_EQ(table.doubts[0].line, 2U);
  EXPECT_EQ(table.record.size(), 2U) << "what follows is not lost";
}

TEST(Csv, SaysWhichRowIsTooLongAndFillsUpOnesThatAreTooShort) {
  const CsvTable table = read_csv("a,b\n1,2,3\n4\n\n,\n");

  ASSERT_EQ(table.doubts.size(), 1U);
  EXPECT_EQ(table.doubts[0].line, 2U);
  EXPECT_EQ(table.record.size(), 2U) << "blank rows are left out";
  EXPECT_THAT(table.record[1].cell, ElementsAre("4", ""));
}

RC_GTEST_PROP(Csv, ReadsBackEveryTableThatItWrites,
              (const std::vector<std::pair<std::string, std::string>>& rows)) {
  const auto plain = [](std::string text) {
    std::string kept;
    for (const char c : text)
      if (static_cast<unsigned char>(c) >= 0x21 && static_cast<unsigned char>(c) < 0x7F) kept += c;
    return kept.empty() ? std::string("x") : kept;
  };
  std::string text = "a,b\n";
  for (const auto& [a, b] : rows) text += csv_cell(plain(a)) + "," + csv_cell(plain(b)) + "\n";

  const CsvTable table = read_csv(text);

  RC_ASSERT(table.record.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RC_ASSERT(table.record[i].cell[0] == plain(rows[i].first));
    RC_ASSERT(table.record[i].cell[1] == plain(rows[i].second));
  }
}

TEST(Csv, RealCollectionsAreReadAsAnIndependentReaderReadsThem) {
  NEEDS_REFERENCE_DATA("collections/csv/csv.facts.json");
  const auto folder = test::reference_data() / "collections/csv";
  const auto facts = nlohmann::json::parse(std::ifstream(folder / "csv.facts.json"));

  for (const auto& [name, fact] : facts.items()) {
    const CsvTable table = read_csv(test::text_of(folder / name));
    EXPECT_EQ(table.record.size(), fact["objects"].get<std::size_t>()) << name;
    EXPECT_EQ(table.column.size(), fact["columns"].get<std::size_t>()) << name;
    const auto& mapping = fact["mapping"];
    for (const auto& expected : fact["expected"]) {
      const auto record =
          std::ranges::find(table.record, expected["line"].get<std::uint32_t>(), &CsvRecord::line);
      ASSERT_NE(record, table.record.end()) << name << ":" << expected["line"];
      for (const auto& [field, column] : mapping.items()) {
        if (!column.is_string() || !expected.contains(field) || !expected[field].is_string())
          continue;
        const auto at = std::ranges::find(table.column, column.get<std::string>());
        if (at == table.column.end()) continue;
        EXPECT_EQ(record->cell[static_cast<std::size_t>(at - table.column.begin())],
                  expected[field].get<std::string>())
            << name << ":" << expected["line"] << " " << field;
      }
      if (!expected.contains("text_without_html")) continue;
      EXPECT_EQ(plain_text(expected["text.en"].get<std::string>()),
                expected["text_without_html"].get<std::string>())
          << name << ":" << expected["line"];
    }
  }
}

}  // namespace
}  // namespace docent::import::csv_test
