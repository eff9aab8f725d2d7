// deploy/ACCESSIBILITY.md: what is said there, and that it is proved.

#include "tests/deploy/clauses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "tests/deploy/made_file.h"
#include "tests/support/run_program.h"

namespace docent::test::clauses_test {
namespace {

using testing::HasSubstr;

/// "Suite.Name" of every test in the tree.
std::set<std::string, std::less<>> all_tests() {
  static const std::regex written(R"((?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+))");
  std::set<std::string, std::less<>> tests;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_dir() / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = text_of(entry.path());
    for (auto it = std::sregex_iterator(text.begin(), text.end(), written);
         it != std::sregex_iterator(); ++it)
      tests.insert((*it)[1].str() + "." + (*it)[2].str());
  }
  return tests;
}

TEST(AccessibilityPage, SaysWhatTheTableSays) {
  expect_made(source_dir() / "deploy/ACCESSIBILITY.md", accessibility_page());
}

TEST(AccessibilityPage, NamesTestsThatThereAre) {
  const auto tests = all_tests();
  ASSERT_GT(tests.size(), 1000U);
  for (const Clause& clause : clauses())
    for (const std::string_view test : clause.tests)
      EXPECT_TRUE(tests.contains(test)) << clause.number << ": " << test;
}

TEST(AccessibilityPage, ClaimsNothingWithoutATestAndHidesNothingThatIsOpen) {
  using State = Clause::State;
  for (const Clause& clause : clauses()) {
    const bool claims = clause.state == State::Met || clause.state == State::InPart;
    EXPECT_EQ(claims, !clause.tests.empty()) << clause.number;
    if (clause.state == State::Open || clause.state == State::NotConcerned) {
      EXPECT_FALSE(clause.says.empty()) << clause.number;
    }
  }
}

TEST(AccessibilityPage, HasEveryClauseOfChapterFive) {
  std::set<std::string_view> numbers;
  for (const Clause& clause : clauses()) numbers.insert(clause.number);
  for (int i = 1; i <= 16; ++i) EXPECT_TRUE(numbers.contains("5.1.3." + std::to_string(i))) << i;
  for (const char* number : {"5.1.2.2", "5.1.4", "5.1.5", "5.1.6.1", "5.1.6.2", "5.1.7", "5.2",
                             "5.3", "5.4", "5.5.1", "5.5.2", "5.6.1", "5.6.2", "5.7", "5.8", "5.9"})
    EXPECT_TRUE(numbers.contains(number)) << number;
}

TEST(AccessibilityPage, SaysHowItIsHung) {
  const std::string page = text_of(source_dir() / "deploy/ACCESSIBILITY.md");
  for (const char* part : {"`mount_height`", "380 to 1,220 mm", "760 by 1,220 mm"})
    EXPECT_THAT(page, HasSubstr(part));
}

TEST(AccessibilityPage, IsLinkedFromTheReadme) {
  EXPECT_THAT(text_of(source_dir() / "README.md"), HasSubstr("deploy/ACCESSIBILITY.md"));
}

}  // namespace
}  // namespace docent::test::clauses_test
