#include "tests/deploy/made_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "tests/support/run_program.h"

namespace docent::test {

void expect_made(const std::filesystem::path& file, std::string_view text) {
  if (std::getenv("DOCENT_UPDATE_PAGES") != nullptr) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
  EXPECT_TRUE(text_of(file) == text)
      << file << " is not what the tables give. Write it anew, look at it and commit it:\n"
      << "  DOCENT_UPDATE_PAGES=1 " << program("test_deploy").string();
}

}  // namespace docent::test
