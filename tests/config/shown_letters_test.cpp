#include "config/shown_letters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace docent::config::shown_letters_test {
namespace {

std::string said_by(const std::string& command) {
  const std::unique_ptr<std::FILE, decltype(&pclose)> pipe(
      popen((command + " 2>/dev/null").c_str(), "r"),
      pclose);  // NOLINT(bugprone-command-processor)
  std::string text;
  std::array<char, 4096> some{};
  while (pipe && std::fgets(some.data(), some.size(), pipe.get()) != nullptr) text += some.data();
  return text;
}

/// By letter: does a font of those packages have it?
std::vector<bool> letters_of_the_packages() {
  std::vector<bool> has(0x110000);
  std::istringstream ranges(
      said_by("dpkg -L fonts-inter fonts-noto-cjk fonts-noto-core | grep -E '[.](ttf|otf|ttc)$' | "
              "xargs fc-query --format '%{charset}\n'"));
  for (std::string range; ranges >> range;) {
    const std::size_t dash = range.find('-');
    const unsigned long first = std::stoul(range, nullptr, 16);
    const unsigned long last =
        dash == std::string::npos ? first : std::stoul(range.substr(dash + 1), nullptr, 16);
    for (unsigned long letter = first; letter <= last; ++letter) has.at(letter) = true;
  }
  return has;
}

TEST(ShownLetters, AreThoseOfTheFontsThatAKioskDependsOn) {
  const std::vector<bool> has = letters_of_the_packages();
  if (!has['a'] || !has[0x9752] || !has[0x0E01])
    GTEST_SKIP() << "Debian's fonts or fc-query are not here";

  std::uint32_t differ = 0;
  for (std::uint32_t letter = 0; letter < has.size(); ++letter)
    if (is_shown(letter) != has[letter]) {
      ADD_FAILURE() << "U+" << std::hex << letter << (has[letter] ? " is there" : " is missing");
      if (++differ > 20) break;
    }
}

TEST(ShownLetters, AreThoseOfTheLanguagesThatDocentShips) {
  for (const char32_t letter : U"aé–„“ßñЯы青铜鼎あ한عאקहिกฏ。、€…•")
    EXPECT_TRUE(letter == 0 || is_shown(letter)) << std::hex << std::uint32_t{letter};
  EXPECT_FALSE(is_shown(0x10FFFF));
}

}  // namespace
}  // namespace docent::config::shown_letters_test
