#include <gmock/gmock.h>

#include "tests/support/museum_folder.h"
#include "tests/support/sample_database.h"

namespace docent::command::graph_command_test {
namespace {

using test::run_program;
using testing::HasSubstr;

TEST(TheGraphCommand, DrawsEveryClipOfADatabaseByItsName) {
  const test::TemporaryFolder folder;
  const std::string picture = (folder.path() / "graph.svg").string();

  const test::ProgramRun run =
      run_program("docent-content",
                  "graph '" + test::sample_database().string() + "' -o '" + picture + "' --json");

  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(test::text_of(picture), HasSubstr("walk-to-stand"));
  EXPECT_THAT(run.out, HasSubstr("\"name\":\"walk-to-stand\""));
  EXPECT_THAT(run.out, HasSubstr("\"transitions\":[{"));
}

TEST(TheGraphCommand, SaysThatADatabaseWithoutMotionHasNone) {
  const test::MuseumFolder museum;
  ASSERT_EQ(museum.compile("--no-motion").exit_code, 0);

  const test::ProgramRun run =
      run_program("docent-content", "graph '" + museum.database().string() + "' -o '" +
                                        (museum.path() / "graph.svg").string() + "'");

  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("error[no-motion]: this database holds no motion"));
  EXPECT_FALSE(std::filesystem::exists(museum.path() / "graph.svg"));
}

}  // namespace
}  // namespace docent::command::graph_command_test
