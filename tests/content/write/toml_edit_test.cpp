#include "content/write/toml_edit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "config/toml_document.h"

namespace docent::write::toml_edit_test {
namespace {

TEST(TomlEdit, ReplacesAValueAndLeavesTheRest) {
  EXPECT_EQ(
      edited("# é\na = \"old\"  # why\nb = 2\n", {{TomlEdit::Kind::Replace, 2, 5, "\"new\""}}),
      "# é\na = \"new\"  # why\nb = 2\n");
}

TEST(TomlEdit, InsertsBelowATextOfSeveralLines) {
  EXPECT_EQ(edited("t.en = \"\"\"a\nb\"\"\"\nx = 1\n",
                   {{TomlEdit::Kind::InsertAfter, 1, 8, "t.ar = \"c\""}}),
            "t.en = \"\"\"a\nb\"\"\"\nt.ar = \"c\"\nx = 1\n");
}

TEST(TomlEdit, KeepsTheLineEndsOfWindows) {
  EXPECT_EQ(edited("a = \"b\"\r\nc = 1\r\n", {{TomlEdit::Kind::InsertAfter, 1, 5, "d = \"e\""}}),
            "a = \"b\"\r\nd = \"e\"\r\nc = 1\r\n");
}

TEST(TomlEdit, LeavesOutWhatIsNoText) {
  EXPECT_EQ(edited("a = 1\n",
                   {{TomlEdit::Kind::Replace, 1, 5, "2"}, {TomlEdit::Kind::Replace, 9, 1, "x"}}),
            "a = 1\n");
}

TEST(TomlEdit, KnowsTheKeyBeforeAValue) {
  EXPECT_EQ(key_before("title.en = \"x\"\n", 1, 12), "title.en");
  EXPECT_EQ(key_before("title = {en = \"x\"}\n", 1, 15), "");
}

RC_GTEST_PROP(TomlEdit, AnyTextComesBackThroughTheReader, (std::string text)) {
  std::erase_if(text,
                [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0 || c == 0; });
  std::erase(text, '.');  // a line of many is refused

  const config::TomlFile file = config::parse_toml("a = " + toml_text(text) + "\n", "x.toml");

  RC_ASSERT(file.root.has_value());
  RC_ASSERT(file.root->entries.at(0).value.text == text);
}

}  // namespace
}  // namespace docent::write::toml_edit_test
