#include "content/film/studio.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "platform/image/image.h"
#include "runtime/scene/body_detail.h"

namespace docent::film {
namespace {

/// Of the longest side: a picture on a wall of the model is seldom larger in a film.
constexpr std::uint32_t wall_picture_side = 144;

scene::TextureId texture_of(std::size_t image) noexcept {
  return static_cast<scene::TextureId>(1 + image);
}

}  // namespace

Studio::Studio(std::unique_ptr<headless::HeadlessDisplay> display, gles::Renderer renderer)
    : display_(std::move(display)), renderer_(std::move(renderer)) {}

void Studio::furnish(const Museum& museum) {
  for (std::size_t i = 0; i < museum.images.size(); ++i) {
    const auto picture = image::decode_at_least(museum.images[i].bytes, wall_picture_side);
    if (picture)  // else the wall stays empty, as on the kiosk
      holdings_.add_scenery_image(texture_of(i),
                                  image::mip_levels(image::shrink(*picture, wall_picture_side)));
  }
  std::vector<scene::TextureId> image_of;
  for (const Exhibit& exhibit : museum.exhibits) image_of.push_back(texture_of(exhibit.image));
  for (std::uint32_t floor = 0; floor < museum.scenery.size(); ++floor)
    while (holdings_.add_scenery(floor, museum.scenery[floor], image_of)) {
    }
  for (std::size_t i = 0; i < museum.objects.size(); ++i)
    holdings_.add_object(static_cast<std::uint32_t>(i), museum.objects[i].size,
                         museum.objects[i].distant);
  holdings_.set_body(museum.avatar, scene::levels_of(museum.avatar));
}

Pixels Studio::take(const scene::DrawList& list) {
  Pixels picture;
  renderer_.draw(list, holdings_, display_->target());
  display_->read_back(picture);
  return picture;
}

float Studio::aspect() const noexcept {
  const PixelSize size = display_->target().size;
  return static_cast<float>(size.width) / static_cast<float>(size.height);
}

Result<Studio> open_studio(const Museum& museum, PixelSize size) {
  auto display = headless::open_headless(size);
  if (!display) return std::unexpected(display.error());
  auto renderer = gles::make_renderer();
  if (!renderer) return std::unexpected(renderer.error());
  Studio studio(std::move(*display), std::move(*renderer));
  studio.furnish(museum);
  return studio;
}

}  // namespace docent::film
