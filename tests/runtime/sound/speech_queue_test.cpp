#include "runtime/sound/speech_queue.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <thread>

namespace docent::sound::speech_queue_test {
namespace {

/// A sound of packets whose bytes after the first are `mark`.
SpeechSound sound_of(std::size_t packets, std::size_t size, unsigned mark) {
  SpeechSound sound;
  sound.skip = 312;
  sound.samples = static_cast<std::uint32_t>(packets * 960 - 312);
  for (std::size_t i = 0; i < packets; ++i) {
    sound.packets.push_back(static_cast<std::byte>(size & 0xffU));
    sound.packets.push_back(static_cast<std::byte>(size >> 8U));
    sound.packets.push_back(std::byte{0x48});
    sound.packets.insert(sound.packets.end(), size - 1, static_cast<std::byte>(mark));
  }
  return sound;
}

TEST(SpeechQueue, GivesSoundsAndPausesInTheirOrder) {
  SpeechQueue queue;
  const SpeechSound sound = sound_of(2, 40, 7);
  const SpeechPart parts[] = {{&sound, true}, {nullptr, true}, {&sound, false}};

  queue.say(parts);

  SpeechQueue::Item item;
  ASSERT_TRUE(queue.pop(item));
  EXPECT_TRUE(item.begins);
  EXPECT_EQ(item.skip, 312U);
  EXPECT_EQ(item.packet.size(), 40U);
  EXPECT_EQ(item.packet[39], std::byte{7});
  ASSERT_TRUE(queue.pop(item));
  EXPECT_FALSE(item.begins);
  for (int pauses = 0; pauses < 2; ++pauses) {
    ASSERT_TRUE(queue.pop(item));
    EXPECT_TRUE(item.packet.empty());
    EXPECT_EQ(item.samples, SpeechQueue::pause);
  }
  ASSERT_TRUE(queue.pop(item));
  EXPECT_TRUE(item.begins);
  ASSERT_TRUE(queue.pop(item));
  EXPECT_FALSE(queue.pop(item));
}

TEST(SpeechQueue, GivesALongSilenceAtOnce) {
  SpeechQueue queue;
  const SpeechPart part{nullptr, 4000};

  queue.say({&part, 1});

  SpeechQueue::Item item;
  ASSERT_TRUE(queue.pop(item));
  EXPECT_TRUE(item.packet.empty());
  EXPECT_EQ(item.samples, 4000 * SpeechQueue::pause);
  EXPECT_FALSE(queue.pop(item));
}

TEST(SpeechQueue, GivesTheNumberOfASoundInAnArchive) {
  SpeechQueue queue;
  SpeechSound sound = sound_of(1, 40, 7);
  sound.packets = {};
  sound.archived = 70'000;
  const SpeechPart part{&sound, true};

  queue.say({&part, 1});

  SpeechQueue::Item item;
  ASSERT_TRUE(queue.pop(item));
  EXPECT_EQ(item.archived, 70'000U);
  EXPECT_EQ(item.samples, sound.samples);
  EXPECT_TRUE(item.packet.empty());
  ASSERT_TRUE(queue.pop(item));
  EXPECT_EQ(item.archived, std::nullopt);
  EXPECT_FALSE(queue.pop(item));
}

RC_GTEST_PROP(SpeechQueueProperty, OnlyTheLastSentenceIsHeard, ()) {
  SpeechQueue queue;
  std::uint32_t said = 0;
  unsigned last = 0;
  for (int turns = *rc::gen::inRange(1, 300); turns > 0; --turns) {
    last = *rc::gen::inRange(0U, 256U);
    const SpeechSound sound = sound_of(*rc::gen::inRange<std::size_t>(1, 40),
                                       *rc::gen::inRange<std::size_t>(1, 1276), last);
    const SpeechPart part{&sound, false};
    queue.say({&part, 1});
    ++said;
    SpeechQueue::Item item;
    for (int pops = *rc::gen::inRange(0, 20); pops > 0 && queue.pop(item); --pops) {
      RC_ASSERT(item.sentence == said);
      if (item.packet.size() > 1) RC_ASSERT(item.packet.back() == static_cast<std::byte>(last));
    }
  }
  queue.say({});
  SpeechQueue::Item item;
  RC_ASSERT(!queue.pop(item));
}

TEST(SpeechQueue, LeavesOutWhatDoesNotFitAndGoesOn) {
  SpeechQueue queue;
  const SpeechSound long_one = sound_of(1'000, 1'275, 1);
  const SpeechPart part{&long_one, false};
  queue.say({&part, 1});
  SpeechQueue::Item item;
  std::size_t packets = 0;
  while (queue.pop(item)) ++packets;
  EXPECT_GT(packets, 700U);
  EXPECT_LT(packets, 1'000U);

  queue.say({&part, 1});
  EXPECT_TRUE(queue.pop(item));
}

TEST(SpeechQueue, HoldsBetweenTwoThreads) {
  SpeechQueue queue;
  std::atomic<bool> is_over{false};
  std::jthread speaker([&] {
    for (unsigned i = 0; i < 2'000; ++i) {
      const SpeechSound sound = sound_of(20, 60, i % 256);
      const SpeechPart part{&sound, true};
      queue.say({&part, 1});
    }
    is_over = true;
  });
  std::uint32_t last = 0;
  SpeechQueue::Item item;
  while (!is_over || queue.pop(item)) {
    if (!queue.pop(item)) continue;
    EXPECT_GE(item.sentence, last);
    last = item.sentence;
    if (item.packet.empty()) continue;
    EXPECT_EQ(item.packet.back(), static_cast<std::byte>((item.sentence - 1) % 256));
  }
}

}  // namespace
}  // namespace docent::sound::speech_queue_test
