// What the linker made of the kiosk, as it is installed.

#include <gmock/gmock.h>

#include "tests/support/kiosk_run.h"

namespace docent::test::program_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string read_elf(const std::string& what) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string command =
      "readelf " + what + " --wide '" + program("docent").string() + "' >'" + out + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor)
  return text_of(out);
}

TEST(TheProgram, IsLinkedWithNothingOfTheCompiler) {
  const std::string needed = read_elf("--dynamic");

  ASSERT_THAT(needed, HasSubstr("libsqlite3"));
  for (const char* library : {"CGAL", "gmp", "mpfr", "rsvg", "poppler", "tinygltf", "gdal"})
    EXPECT_THAT(needed, Not(HasSubstr(library)));
}

TEST(TheProgram, BindsAllNamesBeforeItBegins) {
  EXPECT_THAT(read_elf("--dynamic"), HasSubstr("BIND_NOW"));
  EXPECT_THAT(read_elf("--program-headers"), HasSubstr("GNU_RELRO"));
}

TEST(TheProgram, ChecksItsStackAndItsBuffers) {
#ifndef NDEBUG
  GTEST_SKIP() << "what is released does";
#endif
  const std::string symbols = read_elf("--dyn-syms");

  EXPECT_THAT(symbols, HasSubstr("__stack_chk_fail"));
  EXPECT_THAT(symbols, HasSubstr("_chk@GLIBC"));
}

}  // namespace
}  // namespace docent::test::program_test
