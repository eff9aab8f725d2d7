#include "content/speech/wav.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "content/content_error.h"
#include "content/speech/little_endian.h"

namespace docent::speech {

namespace {

constexpr std::uint32_t whole_numbers = 1, floats = 3, extensible = 0xfffe;
constexpr std::uint32_t unknown_length = 0x7f000000;  // and more: a stream

[[noreturn]] void unusable_wav(const std::string& file, const std::string& what) {
  throw content::ContentError(file, 0, 0, "unreadable-recording", what,
                              "save it again as WAV with 16 bits, or as Opus");
}

std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  return static_cast<std::uint32_t>(little_endian(bytes, at, count));
}

struct Format {
  std::uint32_t kind = 0, channels = 0, rate = 0, bits = 0;
};

Format read_format(std::string_view chunk, const std::string& file) {
  if (chunk.size() < 16) unusable_wav(file, "the description of its sound is cut short");
  Format format{.kind = number_at(chunk, 0, 2),
                .channels = number_at(chunk, 2, 2),
                .rate = number_at(chunk, 4, 4),
                .bits = number_at(chunk, 14, 2)};
  if (format.kind == extensible && chunk.size() >= 26) format.kind = number_at(chunk, 24, 2);
  const bool is_read = (format.kind == whole_numbers && format.bits % 8 == 0 && format.bits >= 8 &&
                        format.bits <= 32) ||
                       (format.kind == floats && format.bits == 32);
  if (!is_read)
    unusable_wav(file, fmt::format("its sound is of kind {} with {} bits, which is not read",
                                   format.kind, format.bits));
  if (format.channels < 1 || format.channels > 16)
    unusable_wav(file, fmt::format("it says that it has {} channels", format.channels));
  if (format.rate < least_rate || format.rate > most_rate)
    unusable_wav(file, fmt::format("it has {} samples a second; {} to {} are read", format.rate,
                                   least_rate, most_rate));
  return format;
}

float sample(std::string_view bytes, std::size_t at, const Format& format) {
  const std::uint32_t raw = number_at(bytes, at, format.bits / 8);
  if (format.kind == floats) {
    const auto value = std::bit_cast<float>(raw);
    return std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
  }
  if (format.bits == 8) return (static_cast<float>(raw) - 128) / 128;
  const auto value = static_cast<std::int32_t>(raw << (32 - format.bits));
  return static_cast<float>(static_cast<double>(value) / 2147483648.0);
}

Pcm mixed(std::string_view data, const Format& format, const std::string& file) {
  const std::size_t width = format.bits / 8;
  const std::size_t frames = data.size() / (width * format.channels);
  if (frames == 0) unusable_wav(file, "it holds no sound");
  if (frames > std::size_t{format.rate} * longest_seconds)
    unusable_wav(file, fmt::format("it is longer than {} minutes", longest_seconds / 60));
  Pcm pcm{.rate = format.rate, .samples = std::vector<float>(frames)};
  for (std::size_t i = 0; i < frames; ++i) {
    float sum = 0;
    for (std::size_t channel = 0; channel < format.channels; ++channel)
      sum += sample(data, (i * format.channels + channel) * width, format);
    pcm.samples[i] = sum / static_cast<float>(format.channels);
  }
  return pcm;
}

}  // namespace

Pcm read_wav(std::string_view bytes, const std::string& file) {
  if (bytes.size() < 12 || !bytes.starts_with("RIFF") || bytes.substr(8, 4) != "WAVE")
    unusable_wav(file, "this is no WAV file");
  Format format;
  std::string_view rest = bytes.substr(12);
  while (rest.size() >= 8) {
    const std::string_view name = rest.substr(0, 4);
    const std::uint32_t length = number_at(rest, 4, 4);
    rest.remove_prefix(8);
    const bool is_stream = name == "data" && (length >= unknown_length || length == 0);
    if (length > rest.size() && !is_stream) unusable_wav(file, "it is cut short");
    const std::string_view chunk = rest.substr(0, is_stream ? rest.size() : length);
    if (name == "fmt ") format = read_format(chunk, file);
    if (name == "data") {
      if (format.channels == 0) unusable_wav(file, "nothing says what its sound is like");
      return mixed(chunk, format, file);
    }
    rest.remove_prefix(std::min(rest.size(), std::size_t{length} + length % 2));
  }
  unusable_wav(file, "it holds no sound");
}

}  // namespace docent::speech
