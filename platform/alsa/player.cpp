#include "platform/alsa/player.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "platform/journal/journal.h"
#include "platform/opus/decoder.h"
#include "runtime/model/last_catch.h"
#include "runtime/sound/tempo.h"
#include "runtime/sound/volume.h"

namespace docent::alsa {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto retry = 2s;
constexpr auto longest_wait = 1500ms;  // for a device that is expected
constexpr auto nap = 50ms;  // how long a thread may overlook that it should stop, or a device
constexpr std::size_t block = 960;  // samples that are written at one go: 20 ms

}  // namespace

/// What the player's thread works with.
struct Player::Work {
  Player& player;
  opus::Decoder decoder;
  std::unique_ptr<SoundDevice> device{};
  Clock::time_point next_try{};
  std::string trouble{};  ///< Why there is no device.
  bool has_told = false;  ///< The journal knows that there is no device.
  sound::Tempo tempo{};
  std::uint32_t sentence = 0;           ///< That is being said.
  std::uint32_t skip = 0, samples = 0;  ///< Of the sound that is decoded: still to come.
  float gain = 0;
  std::array<float, opus::Decoder::longest> decoded{};
  std::array<float, block> part{};
  std::array<std::int16_t, 2 * block> frames{};

  [[nodiscard]] bool is_device_expected() const {
    return !device && Clock::now() < player.expected_until_.load();
  }

  /// Opens the device where there is none, now and then.
  void look_for_device() {
    if (device || (Clock::now() < next_try && !is_device_expected())) return;
    next_try = Clock::now() + retry;
    auto opened = player.open_();
    if (!opened) {
      trouble = opened.error().what;
      return;
    }
    device = std::move(*opened);
    player.has_device_ = true;
    if (std::exchange(has_told, false))
      journal::tell(journal::Message::SoundBack, "the kiosk can be heard again");
  }

  void lose(const std::string& what) {
    device.reset();
    player.has_device_ = false;
    trouble = what;
  }

  /// A kiosk that has nothing to say needs no device: it is missed by the first sentence.
  void tell_loss() {
    if (!trouble.empty() && !std::exchange(has_told, true))
      journal::tell(journal::Message::SoundLost,
                    trouble + "; nothing is heard until it is there, and it is tried again");
  }

  void write(std::span<const float> sound) {
    const float wanted = sound::gain_of(player.volume_);
    const auto out = std::span(frames).first(2 * sound.size());
    sound::to_device(sound, gain, wanted, out);
    gain = wanted;
    if (device)
      if (const auto written = device->write(out); !written) lose(written.error().what);
    if (!device) tell_loss();
    if (!device && player.is_paced_)
      std::this_thread::sleep_for(1s * static_cast<double>(sound.size()) / SpeechSound::rate);
  }

  [[nodiscard]] bool is_interrupted() const { return sentence != player.queue_.sentence(); }

  /// Another sentence has begun, or silence.
  void change_over() {
    sentence = player.queue_.sentence();
    tempo.clear();
    samples = 0;
    if (device) device->drop();
  }

  /// Gives samples to the device, at the visitor's speed.
  void hear(std::span<const float> sound) {
    while (!sound.empty() && !is_interrupted()) {
      tempo.set_speed(player.speed_);
      const auto next = sound.first(std::min(sound.size(), tempo.room()));
      tempo.push(next);
      sound = sound.subspan(next.size());
      while (!is_interrupted()) {
        const std::size_t given = tempo.pull(part);
        if (given == 0) break;
        write(std::span(part).first(given));
      }
    }
  }

  void take(const sound::SpeechQueue::Item& item) {
    if (item.archived) return take_archived(item);
    if (item.packet.empty()) {
      std::ranges::fill(decoded, 0.0F);
      for (std::uint32_t left = item.samples; left > 0 && !is_interrupted();) {
        const std::size_t next = std::min<std::size_t>(left, decoded.size());
        hear(std::span(decoded).first(next));
        left -= static_cast<std::uint32_t>(next);
      }
      return;
    }
    if (item.begins) begin(item);
    take_packet_of_sound(item.packet);
  }

  void begin(const sound::SpeechQueue::Item& item) {
    decoder.forget();
    skip = item.skip;
    samples = item.samples;
  }

  void take_archived(const sound::SpeechQueue::Item& item) {
    const std::shared_ptr<BlobArchive> archive = player.archive_.load();
    if (!archive) return;
    begin(item);
    std::span<const std::byte> rest = archive->read(*item.archived);
    while (!rest.empty() && !is_interrupted()) {
      const auto packet = take_packet(rest);
      if (packet.empty()) return;
      take_packet_of_sound(packet);
    }
  }

  void take_packet_of_sound(std::span<const std::byte> packet) {
    std::span<const float> sound = std::span(decoded).first(decoder.decode(packet, decoded));
    const std::size_t skipped = std::min<std::size_t>(skip, sound.size());
    skip -= static_cast<std::uint32_t>(skipped);
    sound = sound.subspan(skipped);
    sound = sound.first(std::min<std::size_t>(samples, sound.size()));
    samples -= static_cast<std::uint32_t>(sound.size());
    hear(sound);
  }

  /// The sentence has no more items: what waits is said, and then there is silence.
  void end() {
    while (!is_interrupted()) {
      const std::size_t given = tempo.finish(part);
      if (given == 0) break;
      write(std::span(part).first(given));
    }
    if (is_interrupted()) return;
    if (device) device->rest();
    player.ended_ = sentence;
  }
};

Player::Player(Open open, bool is_paced)
    : open_(std::move(open)), is_paced_(is_paced), thread_([this](const std::stop_token& stop) {
        keep_running("playing sound", stop, [&] { play(stop); });
      }) {}

std::unique_ptr<Player> Player::of(const std::string& device) {
  return std::make_unique<Player>([device] { return open_device(device); },
                                  !device.starts_with("file:"));
}

Player::~Player() {
  thread_.request_stop();
  awake_.release();
}

void Player::use(std::shared_ptr<BlobArchive> archive) noexcept {
  say({});
  archive_.store(std::move(archive));
}

void Player::say(std::span<const sound::SpeechPart> parts) noexcept {
  queue_.say(parts);
  awake_.release();
}

void Player::expect_device() noexcept {
  if (!has_device_) expected_until_ = Clock::now() + longest_wait;
  awake_.release();
}

void Player::play(const std::stop_token& stop) {
  auto decoder = opus::Decoder::open();
  if (!decoder) {
    journal::tell(journal::Message::SoundLost, decoder.error().what);
    return;
  }
  const auto work = std::make_unique<Work>(*this, std::move(*decoder));
  while (!stop.stop_requested()) {
    work->look_for_device();
    if (work->is_interrupted()) work->change_over();
    if (work->is_device_expected()) {
      static_cast<void>(awake_.try_acquire_for(nap));
      continue;
    }
    const bool is_whole = queue_.is_whole();  // before the pop: what follows it is not yet known
    sound::SpeechQueue::Item item;
    if (queue_.pop(item)) {
      if (item.sentence != work->sentence) work->change_over();
      work->take(item);
    } else if (is_whole && is_speaking() && !work->is_interrupted()) {
      work->end();
    } else {
      static_cast<void>(awake_.try_acquire_for(nap));
    }
  }
}

}  // namespace docent::alsa
