#include "runtime/kiosk/staff_lock.h"

#include <gtest/gtest.h>

#include "platform/pin/pin.h"

namespace docent::kiosk::staff_lock_test {
namespace {

std::optional<bool> tried(StaffLock& lock, const char* pin, double time) {
  lock.try_pin(pin, time);
  lock.wait();
  return lock.answer(time);
}

TEST(StaffLock, OpensToItsPin) {
  StaffLock lock(*pin::hash("4711"));

  EXPECT_EQ(tried(lock, "4711", 0), true);
  EXPECT_EQ(lock.pause_left(0), 0);
}

TEST(StaffLock, PausesLongerAfterEveryWrongPin) {
  StaffLock lock(*pin::hash("4711"));

  double time = 0;
  for (const double pause : {1., 2., 4., 8.}) {
    EXPECT_EQ(tried(lock, "0000", time), false);
    EXPECT_EQ(lock.pause_left(time), pause);
    EXPECT_EQ(tried(lock, "4711", time + pause / 2), std::nullopt) << "not even the right one";
    time += pause;
  }
  EXPECT_EQ(tried(lock, "4711", time), true);
  EXPECT_EQ(tried(lock, "0000", time), false);
  EXPECT_EQ(lock.pause_left(time), 1) << "the right one has them forgotten";
}

TEST(StaffLock, WithoutAPinNeverOpens) {
  StaffLock lock("");

  EXPECT_FALSE(lock.has_pin());
  EXPECT_EQ(tried(lock, "", 0), std::nullopt);
}

}  // namespace
}  // namespace docent::kiosk::staff_lock_test
