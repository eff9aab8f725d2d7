#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/run_program.h"

namespace docent::test {

/// The sample museum, compiled once for this build of docent-content. Tests that run side by side
/// may each compile it: the file appears whole, and always with the same bytes.
inline std::filesystem::path sample_database() {
  const std::filesystem::path file = program("docent").parent_path() / "sample-museum.db";
  const auto newest_source = [] {
    auto newest = std::filesystem::last_write_time(program("docent-content"));
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(source_dir() / "config/museum"))
      newest = std::max(newest, entry.last_write_time());
    return newest;
  };
  if (std::filesystem::exists(file) && std::filesystem::last_write_time(file) > newest_source())
    return file;
  const ProgramRun compiled =
      run_program("docent-content", "compile '" + (source_dir() / "config/museum").string() +
                                        "' -o '" + file.string() + "' --quiet");
  EXPECT_EQ(compiled.exit_code, 0) << compiled.err;
  return file;
}

}  // namespace docent::test
