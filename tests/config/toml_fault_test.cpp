#include "config/toml_fault.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace docent::config::toml_fault_test {
namespace {

// What people are told of each mistake is in tests/content/compile/staff_mistakes_test.cpp.

TEST(TomlFault, PointsAtTheLineOfTheMistakeNotWhereItWasNoticed) {
  const TomlFault fault =
      explain_toml_fault("a = [1,\n  2\nb = 3\n", {.line = 3, .column = 1, .length = 1}, false);

  EXPECT_EQ(fault.range.line, 1U);
  EXPECT_EQ(fault.message, "the list that begins here is not closed");
}

TEST(TomlFault, CountsLettersNotBytes) {
  const TomlFault fault =
      explain_toml_fault("é = “x”\n", {.line = 1, .column = 1, .length = 1}, false);

  EXPECT_EQ(fault.range.column, 5U);
}

RC_GTEST_PROP(TomlFault, AnyBytesAreAnsweredWithASentenceAndAPlaceInTheText,
              (const std::string& text, std::uint32_t line, std::uint32_t column, bool twice)) {
  const TomlFault fault =
      explain_toml_fault(text, {.line = line, .column = column, .length = 1}, twice);

  RC_ASSERT(!fault.message.empty());
  RC_ASSERT(!fault.hint.empty());
}

/// Lines as staff write them, spoilt in one place.
RC_GTEST_PROP(TomlFault, ASpoiltFileIsNeverExplainedOutsideOfItsLines, ()) {
  const std::string whole =
      "[[exhibit]]\nid = \"a\"\nposition = [1.5, 2]\ntitle.en = \"\"\"x\ny\"\"\"\n[b]\nc = true\n";
  const auto at = *rc::gen::inRange<std::size_t>(0, whole.size());
  const char with = *rc::gen::element('"', '[', ']', '=', '\'', '\\', 'x', '\n', ',');
  std::string text = whole;
  text[at] = with;

  const TomlFile file = parse_toml(text, "x.toml");

  if (file.root) return;
  RC_ASSERT(file.diagnostics.size() == 1U);
  RC_ASSERT(file.diagnostics[0].line >= 1U);
  RC_ASSERT(file.diagnostics[0].line <= 9U);
  RC_ASSERT(file.diagnostics[0].column >= 1U);
}

}  // namespace
}  // namespace docent::config::toml_fault_test
