#include "content/compile/load_video.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>
#include <utility>

#include "content/content_error.h"
#include "content/read_source.h"
#include "platform/image/image.h"
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
          fmt::format("ffmpeg -i FILM -an -c:v libvpx-vp9 -vf scale=-2:{},fps=25 -t {} "
                      "{}.webm makes one of nearly any film",
                      limits.shortest_side, limits.duration.count(), file.stem().string())};
}

Pixels pixels_of(const video::Planes& planes) {
  Pixels picture{.width = planes.width,
                 .height = planes.height,
                 .rgba = std::vector<std::byte>(std::size_t{4} * planes.width * planes.height)};
  video::fill_pixels(planes, picture);
  return picture;
}

/// Decodes every frame; the first one that is seen.
Result<Pixels> first_picture(const video::Video& video, std::span<const std::byte> bytes) {
  Result<vpx::Decoder> decoder = vpx::Decoder::open(video);
  if (!decoder) return std::unexpected(decoder.error());
  Pixels first;
  for (std::size_t i = 0; i < video.frames.size(); ++i) {
    const video::Frame& frame = video.frames[i];
    const Result<video::Planes> planes = decoder->decode(bytes.subspan(frame.at, frame.size));
    if (!planes)
      return std::unexpected(Error{planes.error().code, fmt::format("frame {} of this video {}",
                                                                    i + 1, planes.error().what)});
    if (planes->y != nullptr && first.rgba.empty()) first = pixels_of(*planes);
  }
  if (first.rgba.empty())
    return std::unexpected(Error{Errc::InvalidInput, "no frame of this video is seen"});
  return first;
}

}  // namespace

bool is_video(const std::filesystem::path& file) {
  std::array<char, 4> head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size());
  return std::string_view(head.data(), head.size()) == "\x1a\x45\xdf\xa3";  // RFC 8794, 11.2.1
}

LoadedVideo load_video(const std::filesystem::path& file, const std::string& name,
                       const video::Limits& limits) {
  LoadedVideo loaded{
      .video = {}, .bytes = content::read_source(file, "unreadable-video"), .poster = {}};
  const auto bytes = std::as_bytes(std::span(loaded.bytes));
  Result<video::Video> video = video::read_webm(bytes, limits);
  if (!video) throw unreadable(file, video.error().what, limits);
  if (const auto fault = video::beyond(*video, limits)) throw unreadable(file, *fault, limits);
  const Result<Pixels> first = first_picture(*video, bytes);
  if (!first) throw unreadable(file, first.error().what, limits);
  auto poster = image::encode_jpeg(*first);
  if (!poster) throw unreadable(file, poster.error().what, limits);
  loaded.video = std::move(*video);
  loaded.poster = {
      .name = name, .width = first->width, .height = first->height, .bytes = std::move(*poster)};
  return loaded;
}

}  // namespace docent::compile
