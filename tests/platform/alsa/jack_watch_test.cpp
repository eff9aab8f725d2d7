#include "platform/alsa/jack_watch.h"

#include <gtest/gtest.h>

namespace docent::alsa::jack_watch_test {
namespace {

using namespace std::chrono_literals;

TEST(HeadphoneJack, IsKnownByItsName) {
  for (const char* name :
       {"Headphone Jack", "Front Headphone Jack", "Headset Jack", "Dock Headphone Jack"})
    EXPECT_TRUE(is_headphone_jack(name)) << name;
  for (const char* name :
       {"Headphone Playback Switch", "Mic Jack", "Headset Mic Jack", "HDMI/DP,pcm=3 Jack",
        "Speaker Phantom Jack", "Front Headphone Phantom Jack", ""})
    EXPECT_FALSE(is_headphone_jack(name)) << name;
}

/// Waits until the watch says something; nothing within ten seconds.
std::optional<bool> next_change(JackWatch& watch) {
  for (int i = 0; i < 2'000; ++i) {
    if (const auto change = watch.changed()) return change;
    std::this_thread::sleep_for(5ms);
  }
  return std::nullopt;
}

TEST(JackWatch, TellsEachChangeOnce) {
  std::atomic<int> state{0};  // 0 out, 1 in, 2 nobody knows
  JackWatch watch([&](std::chrono::milliseconds) -> std::optional<bool> {
    std::this_thread::sleep_for(1ms);
    if (state == 2) return std::nullopt;
    return state == 1;
  });
  EXPECT_EQ(watch.changed(), std::nullopt);
  state = 1;
  EXPECT_EQ(next_change(watch), true);
  EXPECT_EQ(watch.changed(), std::nullopt);
  state = 2;  // the card is pulled out, with the headphones in it
  EXPECT_EQ(next_change(watch), false);
}

TEST(JackWatch, OfAMachineWithoutACardEnds) {
  JackWatch watch;
  EXPECT_EQ(watch.changed(), std::nullopt);
}

}  // namespace
}  // namespace docent::alsa::jack_watch_test
