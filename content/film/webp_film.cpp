#include "content/film/webp_film.h"

#include <fmt/format.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <cstdint>
#include <memory>

#include "platform/handle.h"

namespace docent::film {
namespace {

using Encoder = std::unique_ptr<WebPAnimEncoder, CloseWith<WebPAnimEncoderDelete>>;

struct Frame : WebPPicture {
  Frame() : WebPPicture{} { WebPPictureInit(this); }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;
  ~Frame() { WebPPictureFree(this); }
};

struct Film : WebPData {
  Film() : WebPData{} { WebPDataInit(this); }
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  ~Film() { WebPDataClear(this); }
};

WebPConfig quick_and_good() {
  WebPConfig config;
  WebPConfigInit(&config);
  config.quality = 80;
  config.method = 2;
  return config;
}

bool add(const Pixels& picture, int milliseconds, const WebPConfig& config, Encoder& encoder) {
  Frame frame;
  frame.use_argb = 1;
  frame.width = static_cast<int>(picture.width);
  frame.height = static_cast<int>(picture.height);
  return WebPPictureImportRGBX(&frame, reinterpret_cast<const std::uint8_t*>(picture.rgba.data()),
                               4 * frame.width) != 0 &&
         WebPAnimEncoderAdd(encoder.get(), &frame, milliseconds, &config) != 0;
}

}  // namespace

Result<std::vector<std::byte>> encode_webp(std::span<const Pixels> pictures, double seconds) {
  WebPAnimEncoderOptions options;
  WebPAnimEncoderOptionsInit(&options);
  options.minimize_size = 0;
  options.kmin = 9;  // a whole picture now and then, so that one can jump into the film
  options.kmax = 17;
  Encoder encoder(WebPAnimEncoderNew(static_cast<int>(pictures[0].width),
                                     static_cast<int>(pictures[0].height), &options));
  const auto begins = [seconds](std::size_t picture) {
    return static_cast<int>(std::lround(1e3 * seconds * static_cast<double>(picture)));
  };
  const WebPConfig config = quick_and_good();
  bool is_whole = encoder != nullptr;
  for (std::size_t i = 0; is_whole && i < pictures.size(); ++i)
    is_whole = add(pictures[i], begins(i), config, encoder);
  Film film;
  is_whole = is_whole &&
             WebPAnimEncoderAdd(encoder.get(), nullptr, begins(pictures.size()), nullptr) != 0 &&
             WebPAnimEncoderAssemble(encoder.get(), &film) != 0;
  if (!is_whole)
    return std::unexpected(
        Error{Errc::Environment,
              fmt::format("a WebP film cannot be made: {}",
                          encoder ? WebPAnimEncoderGetError(encoder.get()) : "no memory")});
  const auto* first = reinterpret_cast<const std::byte*>(film.bytes);
  return std::vector<std::byte>(first, first + film.size);
}

}  // namespace docent::film
