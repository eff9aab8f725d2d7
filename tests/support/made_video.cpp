#include "tests/support/made_video.h"

#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace docent::test {
namespace {

std::string id_of(std::uint32_t id) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    if (const auto byte = static_cast<char>(id >> shift & 0xFFU); byte != 0 || !bytes.empty())
      bytes += byte;
  return bytes;
}

std::string size_of(std::uint64_t size) {
  std::string bytes = "\x08";  // five bytes
  bytes[0] = static_cast<char>(0x08U | (size >> 32U & 0x07U));
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(size >> shift & 0xFFU);
  return bytes;
}

std::string text_element(std::uint32_t id, const std::string& text) {
  return element(id, text);
}

/// A frame of the sketch in an image of the encoder.
void draw(const VideoSketch& sketch, std::size_t frame, vpx_image_t& image) {
  const std::size_t bar = sketch.width * frame / std::max<std::size_t>(1, sketch.frames);
  for (std::size_t y = 0; y < sketch.height; ++y) {
    unsigned char* row = image.planes[VPX_PLANE_Y] + y * static_cast<std::size_t>(image.stride[0]);
    std::memset(row, 126, sketch.width);
    std::memset(row + bar, 220, std::min<std::size_t>(8, sketch.width - bar));
  }
  for (const int plane : {VPX_PLANE_U, VPX_PLANE_V})
    for (std::size_t y = 0; y < (sketch.height + 1) / 2; ++y)
      std::memset(image.planes[plane] + y * static_cast<std::size_t>(image.stride[plane]), 128,
                  (sketch.width + 1) / 2);
}

void take_packets(vpx_codec_ctx_t& encoder, std::vector<std::string>& out) {
  vpx_codec_iter_t at = nullptr;
  while (const vpx_codec_cx_pkt_t* packet = vpx_codec_get_cx_data(&encoder, &at))
    if (packet->kind == VPX_CODEC_CX_FRAME_PKT)
      out.emplace_back(static_cast<const char*>(packet->data.frame.buf), packet->data.frame.sz);
}

std::string track_of(const VideoSketch& sketch) {
  const bool is_vp8 = sketch.codec == video::Codec::Vp8;
  const std::string codec = !sketch.says_codec.empty() ? sketch.says_codec
                            : is_vp8                   ? "V_VP8"
                                                       : "V_VP9";
  std::string sides = element(0xB0, sketch.says_width != 0 ? sketch.says_width : sketch.width) +
                      element(0xBA, sketch.says_height != 0 ? sketch.says_height : sketch.height);
  const auto say = [&](std::uint32_t id, std::uint32_t number) {
    if (number != 0) sides += element(id, std::uint64_t{number});
  };
  say(0x54B0, sketch.says_shown_width);
  say(0x54BA, sketch.says_shown_height);
  say(0x54B2, sketch.says_unit);
  say(0x54DD, sketch.says_cropped);
  return element(
      0xAE, element(0xD7, 1) + element(0x83, 1) + text_element(0x86, codec) + element(0xE0, sides));
}

}  // namespace

std::string element(std::uint32_t id, const std::string& content) {
  return id_of(id) + size_of(content.size()) + content;
}

std::string element(std::uint32_t id, std::uint64_t number) {
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFFU);
  return element(id, bytes);
}

std::string endless(std::uint32_t id, const std::string& content) {
  return id_of(id) + "\x01\xff\xff\xff\xff\xff\xff\xff" + content;
}

std::vector<std::string> coded_frames(const VideoSketch& sketch) {
  vpx_codec_iface_t* kind =
      sketch.codec == video::Codec::Vp8 ? vpx_codec_vp8_cx() : vpx_codec_vp9_cx();
  vpx_codec_enc_cfg_t settings{};
  if (vpx_codec_enc_config_default(kind, &settings, 0) != VPX_CODEC_OK)
    throw std::runtime_error("libvpx has no encoder");
  settings.g_w = sketch.width;
  settings.g_h = sketch.height;
  settings.g_timebase = {1, 1000};
  settings.g_lag_in_frames = 0;
  settings.rc_target_bitrate = 300;
  vpx_codec_ctx_t encoder{};
  if (vpx_codec_enc_init(&encoder, kind, &settings, 0) != VPX_CODEC_OK)
    throw std::runtime_error("libvpx does not encode this");
  vpx_codec_control_(&encoder, VP8E_SET_CPUUSED, 8);
  vpx_image_t* image = vpx_img_alloc(nullptr, VPX_IMG_FMT_I420, sketch.width, sketch.height, 16);
  std::vector<std::string> frames;
  for (std::size_t i = 0; i < sketch.frames; ++i) {
    draw(sketch, i, *image);
    vpx_codec_encode(&encoder, image, static_cast<vpx_codec_pts_t>(i * sketch.milliseconds_a_frame),
                     sketch.milliseconds_a_frame, 0, VPX_DL_REALTIME);
    take_packets(encoder, frames);
  }
  vpx_codec_encode(&encoder, nullptr, -1, 1, 0, VPX_DL_REALTIME);
  take_packets(encoder, frames);
  vpx_img_free(image);
  vpx_codec_destroy(&encoder);
  return frames;
}

std::string make_video(const VideoSketch& sketch) {
  return make_video(sketch, coded_frames(sketch));
}

std::string make_video(const VideoSketch& sketch, std::span<const std::string> frames) {
  const std::string head =
      element(0x1A45DFA3, element(0x4286, 1) + element(0x42F7, 1) + element(0x42F2, 4) +
                              element(0x42F3, 8) + text_element(0x4282, sketch.says_kind) +
                              element(0x4287, 4) + element(0x4285, 2));
  std::string tracks = track_of(sketch);
  if (sketch.has_sound)
    tracks += element(0xAE, element(0xD7, 2) + element(0x83, 2) + text_element(0x86, "A_OPUS"));
  std::string content =
      element(0x1549A966, element(0x2AD7B1, 1'000'000)) + element(0x1654AE6B, tracks);
  constexpr std::size_t in_a_cluster = 8;
  for (std::size_t first = 0; first < frames.size(); first += in_a_cluster) {
    std::string cluster = element(0xE7, first * sketch.milliseconds_a_frame);
    for (std::size_t i = first; i < std::min(first + in_a_cluster, frames.size()); ++i) {
      if (i < sketch.first) continue;
      const std::uint64_t after = (i - first) * sketch.milliseconds_a_frame;
      std::string block = "\x81";
      block += static_cast<char>(after >> 8U & 0xFFU);
      block += static_cast<char>(after & 0xFFU);
      block += static_cast<char>(i == 0 ? 0x80 : 0);
      cluster += element(0xA3, block + frames[i]);
    }
    content += sketch.is_streamed ? endless(0x1F43B675, cluster) : element(0x1F43B675, cluster);
  }
  return head + (sketch.is_streamed ? endless(0x18538067, content) : element(0x18538067, content));
}

}  // namespace docent::test
