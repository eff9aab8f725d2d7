#include "config/diagnostic_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace docent::config::diagnostic_text_test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(DiagnosticText, ShowsOfALongLineThePartInQuestion) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "docent-long-line.json";
  std::ofstream(file) << std::string(50'000, 'a') << "HERE" << std::string(50'000, 'b') << "\n";

  const std::string text = to_text({.file = file.string(),
                                    .line = 1,
                                    .column = 50'001,
                                    .length = 4,
                                    .code = "odd",
                                    .message = "is odd",
                                    .hint = ""});

  EXPECT_LT(text.size(), 1000U);
  EXPECT_THAT(text, HasSubstr("...aaaa"));
  EXPECT_THAT(text, HasSubstr("bbbb..."));
  // The carets stand under the word.
  const std::size_t word = text.find("HERE"), carets = text.find("^^^^");
  const auto column = [&](std::size_t at) { return at - text.rfind('\n', at); };
  EXPECT_EQ(column(word), column(carets));
  std::filesystem::remove(file);
}

TEST(DiagnosticText, ShowsAShortLineWhole) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "docent-short-line.toml";
  std::ofstream(file) << "name = 3\n";

  const std::string text = to_text({.file = file.string(),
                                    .line = 1,
                                    .column = 8,
                                    .length = 1,
                                    .code = "odd",
                                    .message = "is odd",
                                    .hint = ""});

  EXPECT_THAT(text, HasSubstr("1 | name = 3\n       |        ^\n"));
  EXPECT_THAT(text, Not(HasSubstr("...")));
  std::filesystem::remove(file);
}

TEST(DiagnosticText, ShowsALineThatIsNotUtf8WithoutItsBytes) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "docent-latin1";
  std::ofstream(file, std::ios::binary) << "\xEF\xBB\xBF" << "a = \"\xE9t\xE9\"\n";

  const std::string text =
      to_text({.file = file.string(), .line = 1, .column = 6, .code = "odd", .message = "is odd"});

  EXPECT_THAT(text, HasSubstr("     1 | a = \"\uFFFDt\uFFFD\"\n       |      ^\n"));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace docent::config::diagnostic_text_test
