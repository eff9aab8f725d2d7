#include <gmock/gmock.h>

#include "tests/support/reference_data.h"
#include "tests/support/run_program.h"

namespace docent::command::schema_command_test {
namespace {

// The schema in the tree is what staff's editors read: it is the loader's own table of fields.
TEST(TheSchemaCommand, PrintsTheSchemaThatLiesInTheTree) {
  const test::ProgramRun run = test::run_program("docent-content", "schema");

  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, test::text_of(test::source_dir() / "config/museum.schema.json"));
}

}  // namespace
}  // namespace docent::command::schema_command_test
