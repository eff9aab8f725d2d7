#include "config/look_alike.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::config::look_alike_test {
namespace {

TEST(LookAlike, IsMeantAsTheLetterOfAKeyboard) {
  struct Row {
    const char *written, *meant;
  };
  for (const Row& row :
       {Row{"–", "-"}, Row{"−", "-"}, Row{"，", ","}, Row{"،", ","}, Row{"＝", "="}, Row{"٦", "6"},
        Row{"۹", "9"}, Row{"７", "7"}, Row{"٫", "."}, Row{"「", "\""}, Row{"］", "]"},
        Row{"\u00A0", " "}, Row{"\u200F", ""}}) {
    const auto alike = look_alike(row.written);

    ASSERT_TRUE(alike.has_value()) << row.written;
    EXPECT_EQ(alike->meant, row.meant);
  }
}

TEST(LookAlike, OrdinaryLettersAreOnlyThemselves) {
  for (const char* letter : {"a", "é", "ж", "ع", "青", "-", "\""})
    EXPECT_FALSE(look_alike(letter).has_value()) << letter;
}

TEST(LookAlike, WhatNobodySeesIsNamed) {
  EXPECT_EQ(unseen_character("jade\u200B-disc")->name, "a zero-width space (U+200B)");
  EXPECT_EQ(unseen_character("jade\u00A0disc")->name, "a no-break space (U+00A0)");
  EXPECT_FALSE(unseen_character("jade–disc").has_value());
}

RC_GTEST_PROP(LookAlike, AnyBytesAreSafe, (const std::string& text)) {
  (void)unseen_character(text);
  if (!text.empty()) (void)look_alike(text.substr(0, 4));
}

}  // namespace
}  // namespace docent::config::look_alike_test
