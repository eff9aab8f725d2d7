#pragma once

#include <filesystem>
#include <stdexcept>

#include "tests/support/reference_data.h"

namespace docent::test {

/// The sample museum, which the test sample_museum compiles before all that need it (`SAMPLE` in
/// CMakeLists.txt). Who runs a test program by hand runs that one first.
inline std::filesystem::path sample_database() {
  const std::filesystem::path programs = program("docent-content").parent_path();
  const std::filesystem::path file = programs / "sample-museum.db";
  if (!std::filesystem::exists(file))
    throw std::runtime_error("the sample museum is not compiled yet; ctest --test-dir '" +
                             programs.parent_path().string() + "' -R sample_museum does it");
  return file;
}

}  // namespace docent::test
