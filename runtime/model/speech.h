#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace docent {

/// A piece of what the kiosk says, as sound, or a recording that it plays. Sentences are said by
/// pieces, one after another.
///
/// `packets` are Opus packets (RFC 6716) of one frame and one channel each, every one after its
/// length in two bytes, the lower first. Decoded one after another they give `skip` samples that
/// are left out, and then at least `samples`. Samples are counted at 48 kHz, whatever the bandwidth
/// is.
struct SpeechSound {
  static constexpr std::uint32_t rate = 48'000;         ///< Samples a second.
  static constexpr std::uint32_t longest_frame = 2880;  ///< Samples: 60 ms, the most of one packet.
  static constexpr std::size_t longest_packet = 1275;   ///< Bytes.

  std::uint32_t language = 0;  ///< Of museum.languages.
  std::string text;            ///< What it says, as the guide asks for it.
  std::string made_of;         ///< A digest of all that its sound depends on.
  std::uint32_t skip = 0;
  std::uint32_t samples = 0;
  std::vector<std::byte> packets;
  /// Under which number they lie in an archive (blob_archive.h), if not here.
  std::optional<std::uint32_t> archived{};
};

/// How many samples a packet holds; 0 where it is none of one frame and one channel.
constexpr std::uint32_t samples_of_packet(std::span<const std::byte> packet) noexcept {
  if (packet.empty() || packet.size() > SpeechSound::longest_packet) return 0;
  const auto contents = std::to_integer<std::uint32_t>(packet.front());  // RFC 6716, section 3.1
  if ((contents & 0b111U) != 0) return 0;  // two channels, or several frames
  const std::uint32_t kind = contents >> 3U;
  if (kind < 12) return kind % 4 == 3 ? 2880U : 480U << (kind % 4);
  if (kind < 16) return 480U << (kind % 2);
  return 120U << (kind % 4);
}

/// Takes the next packet off the front of `packets`; empty at their end, and where a length does
/// not fit what is there.
constexpr std::span<const std::byte> take_packet(std::span<const std::byte>& packets) noexcept {
  if (packets.size() < 2) return {};
  const std::size_t length =
      std::to_integer<std::size_t>(packets[0]) + (std::to_integer<std::size_t>(packets[1]) << 8U);
  if (length > packets.size() - 2) return {};
  const auto packet = packets.subspan(2, length);
  packets = packets.subspan(2 + length);
  return packet;
}

/// The samples of all packets; nothing where they are not one packet after another to the end.
constexpr std::optional<std::uint64_t> samples_of_packets(
    std::span<const std::byte> packets) noexcept {
  std::uint64_t samples = 0;
  while (!packets.empty()) {
    const std::uint32_t more = samples_of_packet(take_packet(packets));
    if (more == 0) return std::nullopt;
    samples += more;
  }
  return samples;
}

/// Under which text a museum's sound of that index is kept among what is said: no text of the
/// museum has its first character.
class RecordingKey {
 public:
  static constexpr char first = '\x1f';

  explicit RecordingKey(std::uint32_t sound) noexcept {
    text_.front() = first;
    end_ = std::to_chars(text_.data() + 1, text_.data() + text_.size(), sound).ptr;
  }
  std::string_view text() const noexcept { return {text_.data(), end_}; }
  RecordingKey(const RecordingKey&) = delete;
  RecordingKey& operator=(const RecordingKey&) = delete;

 private:
  std::array<char, 12> text_{};
  const char* end_ = nullptr;
};

/// Is it no piece of speech, but the recording of one of the museum's sounds?
constexpr bool is_recording(const SpeechSound& sound) noexcept {
  return sound.text.starts_with(RecordingKey::first);
}

/// The piece that says `text` in a language; null where there is none. `speech` is sorted by
/// language and text, as a museum's is.
const SpeechSound* find_sound(std::span<const SpeechSound> speech, std::uint32_t language,
                              std::string_view text) noexcept;

}  // namespace docent
