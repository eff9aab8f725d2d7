#include "content/speech/ogg_opus.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "content/content_error.h"
#include "content/speech/little_endian.h"
#include "platform/opus/decoder.h"
#include "runtime/model/speech.h"

namespace docent::speech {

namespace {

[[noreturn]] void unusable_ogg(const std::string& file, const std::string& what) {
  throw content::ContentError(file, 0, 0, "unreadable-recording", what,
                              "save it again as Opus, or as WAV with 16 bits");
}

/// The checksum of a page (RFC 3533, section 6), whose own four bytes count as zero.
std::uint32_t checksum(std::string_view page) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < page.size(); ++i) {
    const bool is_sum = i >= 22 && i < 26;
    sum ^= is_sum ? 0 : std::uint32_t{static_cast<unsigned char>(page[i])} << 24U;
    for (int bit = 0; bit < 8; ++bit) sum = (sum << 1U) ^ ((sum >> 31U) != 0 ? 0x04c11db7U : 0U);
  }
  return sum;
}

struct Page {
  std::uint64_t granule = 0;
  std::uint32_t stream = 0;
  std::string_view lacing, body;
};

/// Takes a page off the front; nothing at the end.
std::optional<Page> take_page(std::string_view& rest, const std::string& file) {
  if (rest.empty()) return std::nullopt;
  constexpr std::size_t header = 27;
  if (rest.size() < header || !rest.starts_with("OggS")) unusable_ogg(file, "it is damaged");
  const std::size_t segments = static_cast<unsigned char>(rest[26]);
  if (rest.size() < header + segments) unusable_ogg(file, "it is cut short");
  Page page{.granule = little_endian(rest, 6, 8),
            .stream = static_cast<std::uint32_t>(little_endian(rest, 14, 4)),
            .lacing = rest.substr(header, segments),
            .body = {}};
  std::size_t length = 0;
  for (const char lace : page.lacing) length += static_cast<unsigned char>(lace);
  if (rest.size() < header + segments + length) unusable_ogg(file, "it is cut short");
  page.body = rest.substr(header + segments, length);
  if (checksum(rest.substr(0, header + segments + length)) != little_endian(rest, 22, 4))
    unusable_ogg(file, "it is damaged: a checksum does not match");
  rest.remove_prefix(header + segments + length);
  return page;
}

/// The packets of the file's first stream, and where its last page says that it ends.
struct Stream {
  std::vector<std::string> packets;
  std::uint64_t end = 0;
};

Stream read_stream(std::string_view bytes, const std::string& file) {
  Stream stream;
  std::optional<std::uint32_t> ours;
  bool goes_on = false;  // the last packet
  while (const auto page = take_page(bytes, file)) {
    if (!ours) ours = page->stream;
    if (page->stream != *ours) continue;
    std::size_t at = 0;
    for (const char lace : page->lacing) {
      const std::size_t length = static_cast<unsigned char>(lace);
      if (!goes_on) stream.packets.emplace_back();
      stream.packets.back() += page->body.substr(at, length);
      at += length;
      goes_on = length == 255;
    }
    if (page->granule != ~std::uint64_t{0}) stream.end = page->granule;
  }
  if (goes_on) unusable_ogg(file, "it is cut short");
  return stream;
}

struct Header {
  std::uint64_t skip = 0;
  float gain = 1;
};

Header read_header(std::string_view packet, const std::string& file) {
  if (packet.starts_with("\x01vorbis") || packet.starts_with("\x7f"
                                                             "FLAC"))
    unusable_ogg(file, "this Ogg file holds Vorbis or FLAC, which is not read");
  if (packet.size() < 19 || !packet.starts_with("OpusHead"))
    unusable_ogg(file, "this is no Opus file");
  const auto channels = static_cast<unsigned char>(packet[9]);
  if (channels < 1 || channels > 2 || packet[18] != 0)
    unusable_ogg(file, fmt::format("it has {} channels; one or two are read", channels));
  const auto gain = static_cast<std::int16_t>(little_endian(packet, 16, 2));  // in decibels / 256
  return {.skip = little_endian(packet, 10, 2),
          .gain = std::pow(10.0F, static_cast<float>(gain) / 5120)};
}

void append(std::span<const float> part, float gain, std::vector<float>& samples) {
  for (const float sample : part) samples.push_back(std::clamp(sample * gain, -1.0F, 1.0F));
}

}  // namespace

Pcm read_ogg_opus(std::string_view bytes, const std::string& file) {
  const Stream stream = read_stream(bytes, file);
  if (stream.packets.empty()) unusable_ogg(file, "this is no Opus file");
  const Header header = read_header(stream.packets.front(), file);
  auto decoder = opus::Decoder::open();
  if (!decoder) throw content::to_content_error(decoder.error(), file, "no-decoder");
  Pcm pcm{.rate = SpeechSound::rate, .samples = {}};
  std::vector<float> part(opus::Decoder::longest);
  for (std::size_t i = 2; i < stream.packets.size(); ++i) {  // after the header and the comments
    const std::size_t more = decoder->decode(std::as_bytes(std::span(stream.packets[i])), part);
    append(std::span(part).first(more), header.gain, pcm.samples);
    if (pcm.samples.size() > std::size_t{longest_seconds} * pcm.rate)
      unusable_ogg(file, fmt::format("it is longer than {} minutes", longest_seconds / 60));
  }
  const std::size_t end = std::min<std::uint64_t>(stream.end, pcm.samples.size());
  if (end <= header.skip) unusable_ogg(file, "it holds no sound");
  pcm.samples.resize(end);
  pcm.samples.erase(pcm.samples.begin(),
                    pcm.samples.begin() + static_cast<std::ptrdiff_t>(header.skip));
  return pcm;
}

}  // namespace docent::speech
