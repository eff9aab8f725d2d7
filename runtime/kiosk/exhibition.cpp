#include "runtime/kiosk/exhibition.h"

#include <malloc.h>

#include <algorithm>
#include <utility>

#include "platform/pango/text_setter.h"
#include "platform/png/image.h"
#include "platform/sqlite/content_reader.h"

namespace docent {
namespace {

/// A little more than a card shows at 1080 lines; 25 pictures then take 33 MB of texture memory.
constexpr std::uint32_t longest_picture_side = 512;

/// A picture that cannot be decoded is left out: its exhibit is shown without one.
Pixels decode(const EncodedImage& image) {
  Result<Pixels> picture = decode_image(image.bytes);
  return picture ? shrink(std::move(*picture), longest_picture_side) : Pixels{};
}

}  // namespace

Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    const GuideSettings& settings) {
  Result<Museum> museum = load_museum(database);
  if (!museum) return std::unexpected(museum.error());
  Result<SetText> set_text = make_text_setter();
  if (!set_text) return std::unexpected(set_text.error());

  auto exhibition = std::make_unique<Exhibition>();
  exhibition->museum = std::move(*museum);
  if (exhibition->museum.floors.empty())
    return std::unexpected(
        Error{Errc::Damaged, database.string() + ": it has no floor; recompile the content"});
  for (EncodedImage& image : exhibition->museum.images) {
    exhibition->pictures.push_back(decode(image));
    image.bytes = {};  // only its pixels are needed from here on
  }
  exhibition->planner = std::make_unique<Planner>(exhibition->museum, std::move(*set_text));
  exhibition->guide = std::make_unique<Guide>(exhibition->museum, *exhibition->planner, settings);
  return exhibition;
}

void upload(Exhibition& exhibition, Renderer& renderer) {
  std::vector<TextureId> image_memory;
  for (const Pixels& picture : exhibition.pictures) {
    const TextureId memory =
        picture.rgba.empty() ? TextureId::None : renderer.upload_image(picture);
    exhibition.guide->bind(image_texture(static_cast<std::uint32_t>(image_memory.size())), memory);
    image_memory.push_back(memory);
  }
  exhibition.pictures = {};

  const Museum& museum = exhibition.museum;
  std::vector<TextureId> picture_of;
  picture_of.reserve(museum.exhibits.size());
  for (const Exhibit& exhibit : museum.exhibits)
    picture_of.push_back(exhibit.image < image_memory.size() ? image_memory[exhibit.image]
                                                             : TextureId::None);
  for (std::uint32_t i = 0; i < museum.scenery.size(); ++i)
    renderer.upload_scenery(i, museum.scenery[i], picture_of);
  renderer.upload_avatar(museum.avatar);
  // The renderer has its own copy of what is only drawn.
  exhibition.museum.scenery = {};
  exhibition.museum.avatar.vertices = {};
  exhibition.museum.avatar.indices = {};
  malloc_trim(
      0);  // reading and decoding left their buffers with the allocator, which would keep them
}

void release(const Exhibition& exhibition, Renderer& renderer) noexcept {
  for (const TextureId memory : exhibition.guide->memory())
    if (memory != TextureId::None) renderer.release(memory);
}

void apply_texts(Guide& guide, Renderer& renderer) noexcept {
  while (const std::unique_ptr<TextChanges> changes = guide.take_texts()) {
    for (const TextureId piece : changes->retired) {
      renderer.release(guide.memory_of(piece));
      guide.bind(piece, TextureId::None);
    }
    for (const TextUpload& upload : changes->uploads)
      guide.bind(upload.texture, renderer.upload_text(upload.bitmap.width, upload.bitmap.height,
                                                      upload.bitmap.coverage));
  }
}

}  // namespace docent
