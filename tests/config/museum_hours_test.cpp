#include "config/museum_hours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/museum_folder.h"

namespace docent::config::museum_hours_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// What is said of a museum whose hall is written like this.
std::vector<Diagnostic> said_of(const std::string& written, const std::string& museum = {}) {
  const test::MuseumFolder folder;
  folder.replace("museum.toml", "label = [5.0, 4.0]\n", "label = [5.0, 4.0]\n" + written + "\n");
  folder.replace("museum.toml", "[museum]\n", "[museum]\n" + museum + "\n");
  return load_museum_config(folder.path()).diagnostics;
}

TEST(MuseumHours, AreToldWrongAtTheLetterWhereTheyCannotBeRead) {
  const auto said = said_of("hours = \"Mo-Fri 10:00-18:00\"");

  ASSERT_THAT(said, SizeIs(1));
  EXPECT_EQ(said[0].code, "bad-hours");
  EXPECT_EQ(said[0].column, 13U);
  EXPECT_THAT(said[0].message, HasSubstr("'hours' cannot be read: this is no weekday"));
  EXPECT_THAT(said[0].hint, HasSubstr("Mo, Tu, We"));
}

TEST(MuseumHours, ThatAreNeverOpenAreAWarning) {
  const auto said = said_of("hours = \"Dec 24-26 off\"");

  ASSERT_THAT(said, SizeIs(1));
  EXPECT_EQ(said[0].severity, Severity::Warning);
  EXPECT_EQ(said[0].code, "never-open");
  EXPECT_THAT(said_of("hours = \"24/7; Dec 24-26 off\"\nclosed = false"), IsEmpty());
}

TEST(MuseumHours, HaveHolidaysThatAreDates) {
  EXPECT_THAT(said_of("", "holidays = [\"Dec 25,26\", \"2027 Mar 26\"]"), IsEmpty());
  const auto said = said_of("", "holidays = [\"Christmas\"]");
  ASSERT_THAT(said, SizeIs(1));
  EXPECT_THAT(said[0].message, HasSubstr("the holiday \"Christmas\" cannot be read"));
}

TEST(MuseumDoors, HaveAnIdOrAName) {
  const auto said_of_door = [](const std::string& called) {
    const test::MuseumFolder folder;
    folder.replace("museum.toml", "[kiosk]",
                   "[[door]]\n" + called + "a = [0, 1]\nb = [0, 2]\n[kiosk]");
    return load_museum_config(folder.path()).diagnostics;
  };
  const auto said = said_of_door("");

  ASSERT_THAT(said, SizeIs(1));
  EXPECT_THAT(said[0].message, HasSubstr("[[door]] lacks 'id'"));
  EXPECT_THAT(said_of_door("id = \"gate\"\n"), IsEmpty());
  EXPECT_THAT(said_of_door("name = \"gate\"\n"), IsEmpty());
}

}  // namespace
}  // namespace docent::config::museum_hours_test
