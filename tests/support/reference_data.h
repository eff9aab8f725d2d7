#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace docent::test {

/// The folder of recordings, plans and descriptors that some tests compare with.
std::filesystem::path reference_data();

/// The root of this source tree.
std::filesystem::path source_dir();

/// Where a program under test is.
std::filesystem::path program(const char* name);

}  // namespace docent::test

/// Skips the test where the reference data is not on this machine.
#define NEEDS_REFERENCE_DATA(path)                                       \
  if (!std::filesystem::exists(docent::test::reference_data() / (path))) \
  GTEST_SKIP() << "no reference data: " << (path)
