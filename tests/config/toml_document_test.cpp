#include "config/toml_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <tuple>

#include "tests/support/wide_text.h"

namespace docent::config::toml_document_test {
namespace {

using testing::HasSubstr;

TEST(TomlDocument, KnowsWhereEachValueStands) {
  const TomlFile file = parse_toml("[kiosk]\nposition = [2.5, 3]\n", "museum.toml");

  ASSERT_TRUE(file.root.has_value());
  const TomlEntry& position = file.root->entries.at(0).value.entries.at(0);
  EXPECT_EQ(position.key, "position");
  EXPECT_EQ(position.key_range.line, 2U);
  EXPECT_EQ(position.key_range.length, 8U);
  EXPECT_EQ(position.value.range.column, 12U);
  EXPECT_EQ(position.value.range.length, 8U);
  EXPECT_EQ(position.value.items.at(0).number, 2.5);
  EXPECT_EQ(position.value.items.at(1).integer, 3);
}

TEST(TomlDocument, CountsColumnsInCharacters) {
  const TomlFile file = parse_toml("a = \"三河\" # x\nb = {c = \"三\", d = 1}\n", "x.toml");

  ASSERT_TRUE(file.root.has_value());
  EXPECT_EQ(file.root->entries.at(0).value.range.length, 4U);
  EXPECT_EQ(file.root->entries.at(1).value.entries.at(1).value.range.column, 19U);
}

TEST(TomlDocument, KeepsTheOrderOfTheFile) {
  const TomlFile file = parse_toml("zebra = 1\napple = 2\n", "x.toml");

  ASSERT_TRUE(file.root.has_value());
  EXPECT_EQ(file.root->entries.at(0).key, "zebra");
}

TEST(TomlDocument, SaysWhereAFileCannotBeRead) {
  const TomlFile file = parse_toml("a = 1\nb = = 2\n", "museum.toml");

  EXPECT_FALSE(file.root.has_value());
  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_EQ(file.diagnostics[0].code, "unreadable-toml");
  EXPECT_EQ(file.diagnostics[0].file, "museum.toml");
  EXPECT_EQ(file.diagnostics[0].line, 2U);
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("two equals signs stand in this line"));
}

TEST(TomlDocument, SaysWhatIsWrongWhereAKeyShouldBegin) {
  for (const char* text : {"[#", "[[[a]]]", "[=", "\u01aa'T", "\u00e9t\u00e9 = 1"}) {
    const TomlFile file = parse_toml(text, "x.toml");

    EXPECT_FALSE(file.root.has_value()) << text;
    ASSERT_EQ(file.diagnostics.size(), 1U) << text;
    EXPECT_EQ(file.diagnostics[0].line, 1U) << text;
  }
}

TEST(TomlDocument, TakesAccentsInTextsAndComments) {
  const TomlFile file = parse_toml("a = \"\u00e9t\u00e9\"  # \u00e9t\u00e9\n", "x.toml");

  ASSERT_TRUE(file.root.has_value());
  EXPECT_EQ(file.root->entries[0].value.text, "\u00e9t\u00e9");
}

TEST(TomlDocument, RefusesKeysOfMorePartsThanTheStackHolds) {
  std::string key = "\na";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  const TomlFile file = parse_toml(key + " = 1", "x.toml");

  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_EQ(file.diagnostics[0].line, 2U);
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("200 full stops"));
}

TEST(TomlDocument, AnswersAnyBytes) {
  EXPECT_TRUE(rc::check("no bytes crash the reader", [](const std::string& text) {
    const TomlFile file = parse_toml(text, "x.toml");

    RC_ASSERT(file.root.has_value() == file.diagnostics.empty());
  }));
}

TEST(TomlDocument, SaysWhichEncodingItCannotRead) {
  for (const auto& [unit, order, name] :
       {std::tuple(2U, test::ByteOrder::Little, "is UTF-16 (little endian)"),
        std::tuple(2U, test::ByteOrder::Big, "is UTF-16 (big endian)"),
        std::tuple(4U, test::ByteOrder::Little, "is UTF-32 (little endian)")}) {
    const TomlFile file = parse_toml(test::wide(U"name = \"三河\"\n", unit, order), "x.toml");

    ASSERT_EQ(file.diagnostics.size(), 1U);
    EXPECT_EQ(file.diagnostics[0].code, "unreadable-toml");
    EXPECT_THAT(file.diagnostics[0].message, HasSubstr(name));
    EXPECT_THAT(file.diagnostics[0].hint, HasSubstr("save the file again as UTF-8"));
  }
}

TEST(TomlDocument, SaysWhereALetterOfLatin1Stands) {
  const TomlFile file = parse_toml("a = 1\ntitle = \"Caf\xE9\"\n", "x.toml");

  ASSERT_EQ(file.diagnostics.size(), 1U);
  EXPECT_EQ(file.diagnostics[0].line, 2U);
  EXPECT_EQ(file.diagnostics[0].column, 13U);
  EXPECT_THAT(file.diagnostics[0].message,
              HasSubstr("it seems, Windows-1252 (or Latin-1): the byte 0xE9 here is 'é'"));
}

TEST(TomlDocument, TakesAByteOrderMarkOfUtf8) {
  const TomlFile file = parse_toml("\xEF\xBB\xBFname = 1\n", "x.toml");

  ASSERT_TRUE(file.root.has_value());
  EXPECT_EQ(file.root->entries.at(0).key_range.column, 1U);
}

}  // namespace
}  // namespace docent::config::toml_document_test
