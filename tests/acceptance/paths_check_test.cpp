#include <gtest/gtest.h>

#include "tests/acceptance/run.h"
#include "tests/support/reference_data.h"

namespace docent::test::paths_check_test {
namespace {

/// Reference answers made by other means: see floorplans/SOURCES.md of the reference data.
TEST(PathsCheck, FindsNothingWrongOnTwoMapsThatItsAnswersKnow) {
  NEEDS_REFERENCE_DATA("acceptance/paths_check.py");
  NEEDS_REFERENCE_DATA("floorplans/reference");
  if (run("python3", {"--version"}).exit_code != 0) GTEST_SKIP() << "no python3";

  const Outcome outcome = run("python3", {(reference_data() / "acceptance/paths_check.py").string(),
                                          program("docent-content").string(),
                                          (reference_data() / "floorplans/reference").string(),
                                          "--maps", "museum-s1,westport-f2", "--repeat", "1"});

  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace docent::test::paths_check_test
