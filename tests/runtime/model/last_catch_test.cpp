#include "runtime/model/last_catch.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace docent::last_catch_test {
namespace {

using testing::HasSubstr;

TEST(AThread, ThatThrowsSaysWhatItDidAndWhyAndIsBegunAgain) {
  int begun = 0;

  testing::internal::CaptureStderr();
  keep_running("looking for devices", {}, [&] {
    if (++begun == 1) throw std::runtime_error("No such device");
  });

  EXPECT_EQ(begun, 2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              HasSubstr("docent: looking for devices failed (No such device)"));
}

TEST(AThread, ThatIsToStopIsNotBegunAgain) {
  std::stop_source source;
  int begun = 0;

  keep_running("work", source.get_token(), [&] {
    ++begun;
    source.request_stop();
    throw 1;
  });

  EXPECT_EQ(begun, 1);
}

TEST(GuardedWork, TellsWhetherItEndedByItself) {
  EXPECT_TRUE(guarded("work", [] {}));
  EXPECT_FALSE(guarded("work", [] { throw std::bad_alloc(); }));
}

}  // namespace
}  // namespace docent::last_catch_test
