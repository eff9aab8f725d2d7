// docent-content tour.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/house_folder.h"
#include "tests/support/run_program.h"

namespace docent::command::tour_command_test {
namespace {

using nlohmann::json;
using test::ProgramRun;
using testing::HasSubstr;

class TourOfAHouse : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(house_.compile().exit_code, 0); }
  ProgramRun tour(const std::string& question) const {
    return test::run_program("docent-content",
                             fmt::format("tour '{}' {}", house_.database().string(), question));
  }
  json answer(const std::string& question) const {
    const ProgramRun run = tour("--json " + question);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(run.out, nullptr, false);
  }
  void expect_refused(const std::string& question, int exit_code, const char* sentence) const {
    const ProgramRun run = tour(question);
    EXPECT_EQ(run.exit_code, exit_code) << question;
    EXPECT_THAT(run.err, HasSubstr(sentence)) << question;
  }

  test::HouseFolder house_;
};

TEST_F(TourOfAHouse, IsInTheOrderOfTheShortestWalk) {
  const json found = answer("--exhibits sword,vase");

  EXPECT_EQ(found["order"], json({"vase", "sword"}));
  EXPECT_EQ(found["optimal"], true);
  const double kiosk_to_vase = std::hypot(4, 2);
  EXPECT_NEAR(found["walk_seconds"].get<double>(), kiosk_to_vase + 5 + 20 + 5, 1e-9);
  EXPECT_NEAR(found["seconds"].get<double>(), kiosk_to_vase + 30 + 2 * 60, 1e-9);
  EXPECT_NEAR(found["length"].get<double>(), kiosk_to_vase + 5 + 10 + 5, 1e-9);
}

TEST_F(TourOfAHouse, BeginsAndEndsAsAskedFor) {
  EXPECT_EQ(answer("--exhibits sword,vase --first sword")["order"], json({"sword", "vase"}));
  EXPECT_EQ(answer("--exhibits sword,vase --last vase")["order"], json({"sword", "vase"}));
  EXPECT_EQ(answer("--exhibits vase --first vase --last vase")["order"], json({"vase"}));
}

TEST_F(TourOfAHouse, TakesTheLiftWhereThereMustBeNoSteps) {
  const json found = answer("--exhibits sword,vase --step-free");

  EXPECT_NEAR(found["walk_seconds"].get<double>(), std::hypot(4, 2) + 5 + 28 + 5, 1e-9);
}

TEST_F(TourOfAHouse, ChoosesWhatThereIsTimeFor) {
  EXPECT_EQ(answer("--minutes 10")["order"].size(), 2U);
  EXPECT_EQ(answer("--minutes 1.5")["order"], json({"vase"}));
  EXPECT_LE(answer("--minutes 1.5")["seconds"].get<double>(), 90);
  EXPECT_TRUE(answer("--minutes 0.5")["order"].empty());
}

TEST_F(TourOfAHouse, RefusesWhatMakesNoTour) {
  expect_refused("", 2, "say which exhibits, or how many minutes there are");
  expect_refused("--exhibits vase --minutes 3", 2, "say which exhibits, or how many minutes");
  expect_refused("--exhibits vase,lamp", 2, "there is no exhibit 'lamp'");
  expect_refused("--exhibits vase,vase", 2, "exhibit 'vase' is named twice");
  expect_refused("--exhibits vase --first sword", 2, "exhibit 'sword' is not on the tour");
  expect_refused("--exhibits vase,sword --first vase --last vase", 2, "cannot be both");
  expect_refused("--minutes 3 --last vase", 2, "is chosen too");
}

TEST_F(TourOfAHouse, SaysWhyAnExhibitCannotBeReached) {
  house_.replace("museum.toml", "kind = \"lift\"", "kind = \"lift\"\nclosed = true");
  ASSERT_EQ(house_.compile().exit_code, 0);

  expect_refused("--exhibits vase,sword --step-free", 1, "what is closed is in the way to sword");
}

}  // namespace
}  // namespace docent::command::tour_command_test
