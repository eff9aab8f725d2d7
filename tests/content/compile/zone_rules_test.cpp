#include "content/compile/zone_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/support/house_folder.h"

namespace docent::compile::zone_rules_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class HouseIn : public test::HouseFolder {
 public:
  explicit HouseIn(const std::string& zone) {
    replace("museum.toml", "[museum]\n",
            "[museum]\ntime_zone = \"" + zone + "\"\nholidays = [\"Dec 25\", \"Jan 01\"]\n");
  }
};

TEST(ZoneRules, AreTheLastLineOfATable) {
  EXPECT_EQ(rules_of_table("TZif2\n\x01\x02\nCET-1CEST,M3.5.0,M10.5.0/3\n"),
            "CET-1CEST,M3.5.0,M10.5.0/3");
  EXPECT_EQ(rules_of_table("TZif"), "");
  EXPECT_EQ(rules_of_table("CET-1\n"), "");
}

TEST(ZoneRules, AreKeptInTheDatabaseWithTheHolidays) {
  const HouseIn house("CET-1CEST,M3.5.0,M10.5.0/3");
  ASSERT_EQ(house.compile().exit_code, 0) << house.compile().err;

  const Museum museum = sqlite::load_museum(house.database()).value_or(Museum{});

  EXPECT_EQ(museum.time_zone, "CET-1CEST,M3.5.0,M10.5.0/3");
  EXPECT_EQ(museum.holidays, "Dec 25,Jan 01");
}

TEST(ZoneRules, AreThoseOfAZoneOfTheWorld) {
  const HouseIn house("Europe/Berlin");
  const test::ProgramRun run = house.compile();
  if (run.err.find("install tzdata") != std::string::npos) GTEST_SKIP() << "no tables here";

  EXPECT_EQ(sqlite::load_museum(house.database()).value_or(Museum{}).time_zone,
            "CET-1CEST,M3.5.0,M10.5.0/3");
  EXPECT_THAT(HouseIn("Europe/Berln").compile().err,
              AllOf(HasSubstr("error[unknown-time-zone]"), HasSubstr("Europe/Berlin")));
  EXPECT_THAT(HouseIn("../../etc/passwd").compile().err, HasSubstr("error[unknown-time-zone]"));
}

}  // namespace
}  // namespace docent::compile::zone_rules_test
