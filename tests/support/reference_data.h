#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace docent::test {

/// The folder of recordings, plans and descriptors that some tests compare with.
inline std::filesystem::path reference_data() { return DOCENT_REFERENCE_DATA; }

/// The root of this source tree.
inline std::filesystem::path source_dir() { return DOCENT_SOURCE_DIR; }

/// Where the programs under test are.
inline std::filesystem::path program(const char* name) {
  return std::filesystem::path(DOCENT_BINARY_DIR) / name;
}

}  // namespace docent::test

/// Skips the test where the reference data is not on this machine.
#define NEEDS_REFERENCE_DATA(path)                                \
  if (!std::filesystem::exists(docent::test::reference_data() / (path))) \
  GTEST_SKIP() << "no reference data: " << (path)
