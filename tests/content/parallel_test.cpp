#include "content/parallel.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

namespace docent::content::parallel_test {
namespace {

TEST(ForEachIndex, ThrowsWhereItWasCalledWhatTheFirstIndexThrew) {
  constexpr unsigned jobs = 4;
  const auto fail_from_seven_on = [](std::size_t i) {
    if (i >= 7) throw std::runtime_error("index " + std::to_string(i));
  };

  try {
    for_each_index(100, jobs, fail_from_seven_on);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "index 7");
  }
}

}  // namespace
}  // namespace docent::content::parallel_test
