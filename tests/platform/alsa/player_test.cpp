#include "platform/alsa/player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>
#include <numbers>
#include <vector>

#include "platform/journal/journal.h"
#include "platform/opus/encoder.h"
#include "tests/support/temporary_folder.h"

namespace docent::alsa::player_test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

SpeechSound tone(double hertz, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * opus::encoder_rate));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<float>(
        0.3 * std::sin(2 * std::numbers::pi * hertz * static_cast<double>(i) / opus::encoder_rate));
  auto encoded = opus::encode(samples, 24'000);
  SpeechSound sound;
  sound.skip = encoded->skip;
  sound.samples = encoded->samples;
  sound.packets = std::move(encoded->packets);
  return sound;
}

/// What a device did, for the test's thread.
struct Heard {
  std::mutex mutex;
  std::vector<std::int16_t> samples;
  int drops = 0, openings = 0;
  std::size_t fails_after = SIZE_MAX;  ///< Samples.
  bool is_busy = false;

  std::size_t count() {
    const std::scoped_lock lock(mutex);
    return samples.size();
  }
};

class FakeDevice final : public SoundDevice {
 public:
  explicit FakeDevice(Heard& heard) : heard_(heard) {}
  Result<void> write(std::span<const std::int16_t> samples) noexcept override {
    std::this_thread::sleep_for(1ms);
    const std::scoped_lock lock(heard_.mutex);
    if (heard_.samples.size() + samples.size() > heard_.fails_after)
      return std::unexpected(
          Error{Errc::Environment, "sound device 'fake' takes no sound any more"});
    heard_.samples.insert(heard_.samples.end(), samples.begin(), samples.end());
    return {};
  }
  void drop() noexcept override {
    const std::scoped_lock lock(heard_.mutex);
    ++heard_.drops;
  }
  void rest() noexcept override {}

 private:
  Heard& heard_;
};

Player::Open opening(Heard& heard) {
  return [&heard]() -> Result<std::unique_ptr<SoundDevice>> {
    const std::scoped_lock lock(heard.mutex);
    ++heard.openings;
    if (heard.is_busy)
      return std::unexpected(
          Error{Errc::Environment, "sound device 'fake' is used by another program"});
    return std::make_unique<FakeDevice>(heard);
  };
}

bool becomes(const auto& condition) {
  for (int i = 0; i < 4'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

void say(Player& player, const SpeechSound& sound, bool pause = false) {
  const sound::SpeechPart part{&sound, pause};
  player.say({&part, 1});
}

TEST(Player, SaysASentenceToItsEnd) {
  Heard heard;
  Player player(opening(heard));
  player.set_volume(1);
  const SpeechSound one = tone(200, 0.5), two = tone(300, 0.25);
  const sound::SpeechPart parts[] = {{&one, true}, {nullptr, false}, {&two, false}};

  player.say(parts);

  EXPECT_TRUE(player.is_speaking());
  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_EQ(heard.count(), 2U * (48'000 / 2 + 48'000 / 4 + 48'000 / 4));
  EXPECT_TRUE(player.has_device());
}

TEST(Player, WaitsForADeviceThatIsExpectedSoThatNothingIsLost) {
  Heard heard;
  heard.is_busy = true;
  Player player(opening(heard));
  ASSERT_TRUE(becomes([&] {
    const std::scoped_lock lock(heard.mutex);
    return heard.openings > 0;  // the next try would be seconds later
  }));
  player.expect_device();
  say(player, tone(200, 0.5));
  std::this_thread::sleep_for(300ms);
  {
    const std::scoped_lock lock(heard.mutex);
    heard.is_busy = false;
  }

  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_EQ(heard.count(), 2U * 48'000 / 2) << "the whole sentence";
}

TEST(Player, DoesNotWaitLongForADeviceThatDoesNotCome) {
  Heard heard;
  heard.is_busy = true;
  Player player(opening(heard), false);
  player.expect_device();
  say(player, tone(200, 0.5));
  EXPECT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_EQ(heard.count(), 0U);
}

/// Holds one sound, whatever number is asked for.
class OneSound : public BlobArchive {
 public:
  explicit OneSound(std::vector<std::byte> packets) : packets_(std::move(packets)) {}
  std::span<const std::byte> read(std::uint32_t) override { return packets_; }
  bool read_part(std::uint32_t, std::size_t, std::span<std::byte>) override { return false; }
  void let_go() noexcept override {}

 private:
  std::vector<std::byte> packets_;
};

TEST(Player, SaysSoundsOfAnArchiveAsThoseInMemory) {
  Heard heard;
  Player player(opening(heard));
  SpeechSound one = tone(200, 0.5);
  player.use(std::make_shared<OneSound>(std::exchange(one.packets, {})));
  one.archived = 3;

  say(player, one);

  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_EQ(heard.count(), 2U * 48'000 / 2);
  player.use(nullptr);
  say(player, one);
  EXPECT_TRUE(becomes([&] { return !player.is_speaking(); })) << "silent, without an archive";
}

TEST(Player, EndsASentenceForTheNext) {
  Heard heard;
  Player player(opening(heard));
  say(player, tone(200, 60));
  ASSERT_TRUE(becomes([&] { return heard.count() > 20'000; }));

  player.say({});

  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_LT(heard.count(), 2U * 48'000 * 60);
  EXPECT_GE(heard.drops, 1);
}

TEST(Player, IsSofterAndFasterAsItIsTold) {
  Heard heard;
  Player player(opening(heard));
  player.set_volume(0);
  say(player, tone(200, 0.4));
  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_TRUE(std::ranges::all_of(heard.samples, [](std::int16_t s) { return s == 0; }));

  const std::size_t before = heard.count();
  player.set_speed(2);
  say(player, tone(200, 2));
  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_NEAR(static_cast<double>(heard.count() - before), 2 * 48'000, 6'000);
}

TEST(Player, GoesOnByTheClockWhereTheDeviceIsTakenAndTriesAgain) {
  Heard heard;
  heard.is_busy = true;
  Player player(opening(heard));
  say(player, tone(200, 0.3));
  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_FALSE(player.has_device());
  EXPECT_THAT(journal::last_problem(), HasSubstr("is used by another program; nothing is heard"));
  {
    const std::scoped_lock lock(heard.mutex);
    heard.is_busy = false;
  }
  ASSERT_TRUE(becomes([&] { return player.has_device(); }));
  say(player, tone(200, 0.3));
  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_GT(heard.count(), 20'000U);
}

TEST(Player, OutlivesADeviceThatIsPulledOutInMidSentence) {
  Heard heard;
  heard.fails_after = 20'000;
  Player player(opening(heard));
  say(player, tone(200, 1));
  ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  EXPECT_FALSE(player.has_device());
  EXPECT_LE(heard.count(), 20'000U);
  EXPECT_THAT(journal::last_problem(), HasSubstr("takes no sound any more; nothing is heard"));
  heard.mutex.lock();
  heard.fails_after = SIZE_MAX;
  heard.mutex.unlock();
  EXPECT_TRUE(becomes([&] { return player.has_device(); }));
}

TEST(Player, SpeaksSoonAfterItIsAsked) {
  Heard heard;
  Player player(opening(heard));
  ASSERT_TRUE(becomes([&] { return player.has_device(); }));
  const SpeechSound sound = tone(200, 0.2);
  std::vector<double> delays;
  for (int i = 0; i < 9; ++i) {
    const std::size_t before = heard.count();
    const auto asked = std::chrono::steady_clock::now();
    say(player, sound);
    while (heard.count() == before) std::this_thread::sleep_for(100us);
    delays.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count());
    ASSERT_TRUE(becomes([&] { return !player.is_speaking(); }));
  }
  std::ranges::sort(delays);
  EXPECT_LT(delays[4], 0.04);  // and 60 ms of the device's own: below the 100 ms that are asked for
  RecordProperty("milliseconds", std::to_string(1'000 * delays[4]));
}

std::vector<std::int16_t> samples_of_wav(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::int16_t> samples((bytes.size() - 44) / 2);
  std::memcpy(samples.data(), bytes.data() + 44, 2 * samples.size());
  return samples;
}

TEST(WavDevice, HearsWhatWasSaid) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "heard.wav";
  {
    const auto player = Player::of("file:" + file.string());
    player->set_volume(1);
    say(*player, tone(200, 0.5));
    ASSERT_TRUE(becomes([&] { return !player->is_speaking(); }));
  }
  const auto samples = samples_of_wav(file);
  ASSERT_EQ(samples.size(), 48'000U);
  double power = 0;
  for (const std::int16_t sample : samples) power += std::pow(sample / 32767.0, 2);
  EXPECT_NEAR(power / 48'000, 0.045, 0.01);
}

TEST(SoundDevice, SaysWhyItCannotBeOpened) {
  const auto nothing = open_device("no-such-device");
  ASSERT_FALSE(nothing.has_value());
  EXPECT_THAT(nothing.error().what, HasSubstr("sound device 'no-such-device' cannot be opened"));
  EXPECT_THAT(open_device("file:/no/such/folder/heard.wav").error().what,
              HasSubstr("heard.wav cannot be written"));
}

TEST(AlsaDevice, TakesSoundAsFastAsItsPluginDoes) {
  auto device = open_device("null");
  if (!device) GTEST_SKIP() << device.error().what;
  std::vector<std::int16_t> samples(1'920);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE((*device)->write(samples).has_value()) << i;
  (*device)->rest();
  (*device)->drop();
  EXPECT_TRUE((*device)->write(samples).has_value());
}

}  // namespace
}  // namespace docent::alsa::player_test
