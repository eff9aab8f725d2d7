#include "platform/gles/holdings.h"

#include "platform/gles/holdings_parts.h"

namespace docent::gles {

Holdings::Holdings() : parts_(std::make_unique<Parts>()) {}
Holdings::Holdings(Holdings&&) noexcept = default;
Holdings& Holdings::operator=(Holdings&&) noexcept = default;
Holdings::~Holdings() = default;

void Holdings::add_text(scene::TextureId id, std::uint32_t width, std::uint32_t height,
                        std::span<const std::uint8_t> coverage) noexcept {
  parts_->textures.add_text(id, width, height, coverage);
}

void Holdings::add_image(scene::TextureId id, const Pixels& picture) noexcept {
  parts_->textures.add_image(id, {&picture, 1});
}

void Holdings::add_scenery_image(scene::TextureId id, std::span<const Pixels> levels) noexcept {
  parts_->textures.add_image(id, levels);
}

void Holdings::replace_image(scene::TextureId id, const Pixels& picture) noexcept {
  parts_->textures.replace_image(id, picture);
}

Holdings::Size Holdings::size_of(scene::TextureId id) const noexcept {
  const Textures::Entry* entry = parts_->textures.find(id);
  return entry == nullptr ? Size{} : Size{entry->width, entry->height};
}

void Holdings::release(scene::TextureId id) noexcept {
  parts_->textures.release(id);
}

bool Holdings::add_scenery(std::uint32_t floor, const Scenery& scenery,
                           std::span<const scene::TextureId> image_of) {
  std::vector<Building>& buildings = parts_->buildings;
  if (buildings.size() <= floor) buildings.resize(floor + 1);
  return carry_on(buildings[floor], scenery, image_of);
}

void Holdings::set_body(const SkinnedMesh& mesh, const scene::BodyLevels& levels) {
  parts_->body = make_body(mesh, levels);
}

void Holdings::add_object(std::uint32_t object, Vec3 size, const ObjectMesh& distant) {
  std::vector<Objects::Entry>& entries = parts_->objects.entries;
  if (entries.size() <= object) entries.resize(object + 1);
  entries[object] = {size, make_object_shape(distant)};
}

void Holdings::begin_object_detail(const ObjectDetail& detail) noexcept {
  parts_->objects.coming = make_object_shape(detail);
}

void Holdings::add_object_picture(std::size_t picture, std::span<const Pixels> levels) noexcept {
  add_picture(parts_->objects.coming, picture, levels);
}

void Holdings::show_object_detail(std::uint32_t object) noexcept {
  parts_->objects.detail = std::move(parts_->objects.coming);
  parts_->objects.coming = {};
  parts_->objects.near = object;
}

void Holdings::drop_object_detail() noexcept {
  parts_->objects.detail = {};
}

}  // namespace docent::gles
