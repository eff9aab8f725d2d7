#include "content/speech/library_sound.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "content/content_error.h"

namespace docent::speech {

namespace {

[[noreturn]] void unusable_sound(const std::string& file, const std::string& what) {
  throw content::ContentError(file, 0, 0, "unreadable-recording", what,
                              "save it anew, as FLAC or WAV: Audacity's File > Export does");
}

struct CloseSound {
  void operator()(SNDFILE* sound) const noexcept { sf_close(sound); }
};

/// Bytes that libsndfile reads as a file.
struct SourceBytes {
  std::string_view bytes;
  std::size_t at = 0;
};

sf_count_t length_of_source(void* user) {
  return static_cast<sf_count_t>(static_cast<SourceBytes*>(user)->bytes.size());
}

sf_count_t seek_source(sf_count_t offset, int whence, void* user) {
  SourceBytes& it = *static_cast<SourceBytes*>(user);
  const auto size = static_cast<sf_count_t>(it.bytes.size());
  const sf_count_t from = whence == SEEK_CUR   ? static_cast<sf_count_t>(it.at)
                          : whence == SEEK_END ? size
                                               : 0;
  const sf_count_t by = std::clamp<sf_count_t>(offset, -size, size);  // a file may say anything
  it.at = static_cast<std::size_t>(std::clamp<sf_count_t>(from + by, 0, size));
  return static_cast<sf_count_t>(it.at);
}

sf_count_t read_source_part(void* to, sf_count_t count, void* user) {
  SourceBytes& it = *static_cast<SourceBytes*>(user);
  const std::size_t taken =
      std::min(it.bytes.size() - it.at, static_cast<std::size_t>(std::max<sf_count_t>(count, 0)));
  std::memcpy(to, it.bytes.data() + it.at, taken);
  it.at += taken;
  return static_cast<sf_count_t>(taken);
}

sf_count_t tell_source(void* user) {
  return static_cast<sf_count_t>(static_cast<SourceBytes*>(user)->at);
}

void append_mixed(std::span<const float> frames, std::size_t channels, std::vector<float>& to) {
  for (std::size_t at = 0; at + channels <= frames.size(); at += channels) {
    float sum = 0;
    for (const float sample : frames.subspan(at, channels))
      sum += std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0;
    to.push_back(sum / static_cast<float>(channels));
  }
}

}  // namespace

bool is_library_sound(std::string_view bytes) noexcept {
  const auto holds = [&](std::size_t at, std::string_view what) {
    return bytes.size() > at && bytes.substr(at).starts_with(what);
  };
  if (holds(0, "OggS")) return holds(28, "\x01vorbis") || holds(29, "FLAC");
  const bool is_mpeg = bytes.size() > 1 && bytes[0] == '\xff' &&
                       (static_cast<unsigned char>(bytes[1]) & 0xE6U) == 0xE2U;  // layer III
  return holds(0, "fLaC") || holds(0, "ID3") || is_mpeg || (holds(0, "FORM") && holds(8, "AIF"));
}

Pcm read_library_sound(std::string_view bytes, const std::string& file) {
  SourceBytes source{bytes};
  SF_VIRTUAL_IO io{.get_filelen = length_of_source,
                   .seek = seek_source,
                   .read = read_source_part,
                   .write = nullptr,
                   .tell = tell_source};
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, CloseSound> sound(sf_open_virtual(&io, SFM_READ, &info, &source));
  if (!sound) unusable_sound(file, fmt::format("it cannot be read: {}", sf_strerror(nullptr)));
  if (info.channels < 1 || info.channels > 16)
    unusable_sound(file, fmt::format("it says that it has {} channels", info.channels));
  if (info.samplerate < static_cast<int>(least_rate) ||
      info.samplerate > static_cast<int>(most_rate))
    unusable_sound(file, fmt::format("it has {} samples a second; {} to {} are read",
                                     info.samplerate, least_rate, most_rate));
  Pcm pcm{.rate = static_cast<std::uint32_t>(info.samplerate), .samples = {}};
  const auto channels = static_cast<std::size_t>(info.channels);
  std::array<float, 16 * 1024> block{};
  const auto frames = static_cast<sf_count_t>(block.size() / channels);
  // What its header says of its length may be wrong: it is as long as there is sound.
  for (;;) {
    const sf_count_t got = sf_readf_float(sound.get(), block.data(), frames);
    if (got <= 0) break;
    append_mixed(std::span(block).first(static_cast<std::size_t>(got) * channels), channels,
                 pcm.samples);
    if (pcm.samples.size() > std::size_t{pcm.rate} * longest_seconds)
      unusable_sound(file, fmt::format("it is longer than {} minutes", longest_seconds / 60));
  }
  if (sf_error(sound.get()) != SF_ERR_NO_ERROR)
    unusable_sound(file, fmt::format("it is damaged: {}", sf_strerror(sound.get())));
  if (pcm.samples.empty()) unusable_sound(file, "it holds no sound");
  return pcm;
}

}  // namespace docent::speech
