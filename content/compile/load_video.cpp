#include "content/compile/load_video.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <utility>

#include "content/content_error.h"
#include "content/read_source.h"
#include "platform/vpx/decoder.h"

namespace docent::compile {
namespace {

content::ContentError unreadable(const std::filesystem::path& file, const std::string& why,
                                 const video::Limits& limits) {
  return {file.string(),
          0,
          0,
          "unreadable-video",
          why,
          fmt::format("ffmpeg -i FILM -an -c:v libvpx-vp9 -b:v 1400k -vf \"scale=iw*sar:ih,"
                      "scale={}:{}:force_original_aspect_ratio=decrease:force_divisible_by=2,"
                      "setsar=1,fps=25,format=yuv420p\" -t {} {}.webm makes one of nearly any film",
                      limits.longest_side, limits.shortest_side, limits.duration.count(),
                      file.stem().string())};
}

/// Decodes every frame: what is wrong with the first that cannot be shown; empty where all can.
std::string fault_of(const video::Video& video, std::span<const std::byte> bytes) {
  Result<vpx::Decoder> decoder = vpx::Decoder::open(video);
  if (!decoder) return decoder.error().what;
  bool is_seen = false;
  for (std::size_t i = 0; i < video.frames.size(); ++i) {
    const video::Frame& frame = video.frames[i];
    const Result<video::Planes> planes = decoder->decode(bytes.subspan(frame.at, frame.size));
    if (!planes) return fmt::format("frame {} of this video {}", i + 1, planes.error().what);
    is_seen = is_seen || planes->y != nullptr;
  }
  return is_seen ? std::string() : "no frame of this video is seen";
}

}  // namespace

bool is_video(const std::filesystem::path& file) {
  std::array<char, 4> head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size());
  return std::string_view(head.data(), head.size()) == "\x1a\x45\xdf\xa3";  // RFC 8794, 11.2.1
}

LoadedVideo load_video(const std::filesystem::path& file, const std::string& name,
                       const video::Limits& limits) {
  if (!name.ends_with(".webm"))
    throw content::ContentError(file.string(), 0, 0, "unreadable-video",
                                "this is a video, and its name does not end in .webm",
                                "call it " + file.stem().string() + ".webm");
  const std::string text = content::read_source(file, "unreadable-video");
  const auto bytes = std::as_bytes(std::span(text));
  const Result<video::Video> video = video::read_webm(bytes, limits);
  if (!video) throw unreadable(file, video.error().what, limits);
  if (const auto fault = video::beyond(*video, limits)) throw unreadable(file, *fault, limits);
  if (const std::string fault = fault_of(*video, bytes); !fault.empty())
    throw unreadable(file, fault, limits);
  return {.image = {.name = name,
                    .width = video->width,
                    .height = video->height,
                    .bytes = {bytes.begin(), bytes.end()}},
          .has_sound = video->has_sound};
}

}  // namespace docent::compile
