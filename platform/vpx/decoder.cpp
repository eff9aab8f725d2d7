#include "platform/vpx/decoder.h"

#include <fmt/format.h>
#include <vpx/vp8dx.h>
#include <vpx/vpx_decoder.h>

namespace docent::vpx {
namespace {

vpx_codec_iface_t* interface_of(video::Codec codec) noexcept {
  return codec == video::Codec::Vp8 ? vpx_codec_vp8_dx() : vpx_codec_vp9_dx();
}

std::unexpected<Error> refusal(std::string why) {
  return std::unexpected(Error{Errc::InvalidInput, std::move(why)});
}

const std::uint8_t* bytes_of(std::span<const std::byte> frame) noexcept {
  return reinterpret_cast<const std::uint8_t*>(frame.data());
}

video::Planes planes_of(const vpx_image_t& image) noexcept {
  const auto plane = [&](int i) { return reinterpret_cast<const std::byte*>(image.planes[i]); };
  return {.width = image.d_w,
          .height = image.d_h,
          .y = plane(VPX_PLANE_Y),
          .u = plane(VPX_PLANE_U),
          .v = plane(VPX_PLANE_V),
          .y_stride = image.stride[VPX_PLANE_Y],
          .uv_stride = image.stride[VPX_PLANE_U],
          .is_bt709 = image.cs == VPX_CS_BT_709,
          .is_full_range = image.range == VPX_CR_FULL_RANGE};
}

}  // namespace

void close_decoder(vpx_codec_ctx* decoder) noexcept {
  if (decoder == nullptr) return;
  vpx_codec_destroy(decoder);
  delete decoder;
}

Result<Decoder> Decoder::open(const video::Video& video) {
  Decoder decoder;
  decoder.codec_ = video.codec;
  decoder.width_ = video.width;
  decoder.height_ = video.height;
  auto context = std::make_unique<vpx_codec_ctx>();
  const vpx_codec_dec_cfg_t one_thread{.threads = 1, .w = video.width, .h = video.height};
  const vpx_codec_err_t status =
      vpx_codec_dec_init(context.get(), interface_of(video.codec), &one_thread, 0);
  if (status != VPX_CODEC_OK)
    return std::unexpected(Error{Errc::Environment, fmt::format("videos cannot be decoded: {}",
                                                                vpx_codec_err_to_string(status))});
  decoder.decoder_.reset(context.release());
  return decoder;
}

/// What a key frame says in its head.
bool Decoder::says_its_size(std::span<const std::byte> frame, std::uint32_t& width,
                            std::uint32_t& height) const noexcept {
  vpx_codec_stream_info_t info{};
  info.sz = sizeof info;
  const auto size = static_cast<unsigned>(frame.size());
  if (vpx_codec_peek_stream_info(interface_of(codec_), bytes_of(frame), size, &info) !=
      VPX_CODEC_OK)
    return false;
  width = info.w;
  height = info.h;
  return info.is_kf != 0;
}

Result<video::Planes> Decoder::decode(std::span<const std::byte> frame) {
  const auto other_size = [&](std::uint32_t width, std::uint32_t height) {
    return refusal(fmt::format("is {} x {} pixels, and the video says {} x {}", width, height,
                               width_, height_));
  };
  std::uint32_t width = 0, height = 0;
  if (says_its_size(frame, width, height) && (width != width_ || height != height_))
    return other_size(width, height);
  const vpx_codec_err_t status = vpx_codec_decode(decoder_.get(), bytes_of(frame),
                                                  static_cast<unsigned>(frame.size()), nullptr, 0);
  if (status != VPX_CODEC_OK) return refusal("is damaged");
  vpx_codec_iter_t at = nullptr;
  const vpx_image_t* image = vpx_codec_get_frame(decoder_.get(), &at);
  if (image == nullptr) return video::Planes{};
  if (image->d_w != width_ || image->d_h != height_) return other_size(image->d_w, image->d_h);
  if (image->fmt != VPX_IMG_FMT_I420)
    return refusal("has colours of more than eight bits, or as many as pixels; 4:2:0 is played");
  return planes_of(*image);
}

Result<Pixels> first_picture(std::span<const std::byte> file) {
  const Result<video::Video> video = video::read_webm(file);
  if (!video) return std::unexpected(video.error());
  if (const auto fault = video::beyond(*video)) return refusal(*fault);
  Result<Decoder> decoder = Decoder::open(*video);
  if (!decoder) return std::unexpected(decoder.error());
  for (const video::Frame& frame : video->frames) {
    const Result<video::Planes> planes = decoder->decode(file.subspan(frame.at, frame.size));
    if (!planes) return std::unexpected(planes.error());
    if (planes->y != nullptr) return video::whole_picture(*planes);
  }
  return refusal("no frame of this video is seen");
}

}  // namespace docent::vpx
