#include "content/compile/compile_ways.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/support/house_folder.h"

namespace docent::compile::compile_ways_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class House : public test::HouseFolder {
 public:
  explicit House(std::string_view ways) {
    replace("museum.toml", "[[connection]]\nid = \"stairs\"",
            std::string(ways) + "[[connection]]\nid = \"stairs\"");
  }
  Museum museum() const {
    EXPECT_EQ(compile().exit_code, 0) << compile().err;
    return sqlite::load_museum(database()).value_or(Museum{});
  }
};

TEST(Ways, ThatAMuseumOffersAreKeptInItsOrderWithItsNames) {
  const Museum museum = House(
                            "[[way]]\nkind = \"skeleton\"\ntitle.en = \"Quiet way\"\n"
                            "[[way]]\nkind = \"step_free\"\n")
                            .museum();

  ASSERT_THAT(museum.ways, SizeIs(2));
  EXPECT_EQ(museum.ways[0].choice, WayChoice::Skeleton);
  EXPECT_EQ(museum.ways[0].title.at("en"), "Quiet way");
  EXPECT_EQ(museum.ways[1].choice, WayChoice::StepFree);
  EXPECT_THAT(museum.ways[1].title, IsEmpty());
}

TEST(Ways, AreAllOfferedWhereNothingIsSaid) {
  EXPECT_THAT(House("").museum().ways, IsEmpty());
}

TEST(Ways, ThatAreUnknownOrTwiceAreToldWithTheirPlace) {
  EXPECT_THAT(House("[[way]]\nkind = \"quickest\"\n").compile().err,
              AllOf(HasSubstr("museum.toml:"), HasSubstr("quickest"), HasSubstr("shortest")));
  EXPECT_THAT(House("[[way]]\nkind = \"offset\"\n[[way]]\nkind = \"offset\"\n").compile().err,
              HasSubstr("there are two ways with the kind 'offset'"));
}

TEST(Ways, WithoutAStepFreeOneAreWarnedOfWhereThereAreSteps) {
  const test::ProgramRun without = House("[[way]]\nkind = \"shortest\"\n").compile();
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_THAT(without.err, AllOf(HasSubstr("no-step-free-way"), HasSubstr("step_free")));

  EXPECT_THAT(House("[[way]]\nkind = \"shortest\"\n[[way]]\nkind = \"step_free\"\n").compile().err,
              Not(HasSubstr("no-step-free-way")));
}

}  // namespace
}  // namespace docent::compile::compile_ways_test
