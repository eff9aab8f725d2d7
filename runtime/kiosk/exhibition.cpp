#include "runtime/kiosk/exhibition.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "platform/image/image.h"
#include "platform/pango/text_setter.h"
#include "platform/sqlite/content_reader.h"
#include "platform/sqlite/signature_block.h"
#include "runtime/interface/control.h"
#include "runtime/schema/schema.h"

namespace docent::kiosk {
namespace {

/// A picture on a wall of the model is seldom larger on the screen, and never what one looks at.
constexpr std::uint32_t scenery_picture_side = 144;

/// A picture that cannot be decoded is left out: its exhibit is shown without one.
Pixels decode(const Museum& museum, std::uint32_t image) {
  if (image >= museum.images.size()) return {};
  return image::decode_image(museum.images[image].bytes).value_or(Pixels{});
}

/// Makes the pictures of the building, on other processors while the rest of the start goes on.
/// `pictures` has one for each image of the museum, and stays where it is until all are made.
std::vector<std::future<void>> make_scenery_pictures(const Museum& museum,
                                                     std::span<Pixels> pictures) {
  const std::size_t at_a_time = std::clamp(std::thread::hardware_concurrency(), 1U, 4U);
  std::vector<std::future<void>> made;
  for (std::size_t first = 0; first < at_a_time; ++first)
    made.push_back(std::async(std::launch::async, [&museum, pictures, first, at_a_time] {
      for (std::size_t image = first; image < pictures.size(); image += at_a_time)
        pictures[image] =
            image::shrink(decode(museum, static_cast<std::uint32_t>(image)), scenery_picture_side);
    }));
  return made;
}

/// The guide walks with one radius; labels of the others would lie in memory for the rare way that
/// asks for less room, which can be searched for. Its walks are warped, never raw.
void keep_what_is_walked(Museum& museum) {
  const double walking = museum.body_radius + Museum::walking_room;
  for (Floor& floor : museum.floors)
    for (std::size_t i = 0; i < floor.tangent_graphs.size(); ++i)
      if (floor.tangent_graphs[i].radius != walking) floor.hub_labels[i] = {};
  museum.motion.foresight.raw = {};
}

/// The keys that a database says it is signed with, for `docent status`.
std::string signed_by(const sqlite::Database& database, const Selection& selection) {
  if (database.signatures.empty()) return "none";
  std::vector<std::string> names;
  for (const signature::Signature& signature : database.signatures)
    names.push_back(signature::name_of(signature.key));
  return fmt::format("{}{}", fmt::join(names, ", "),
                     selection.keys.empty() ? " (not verified: kiosk.toml names no keys)" : "");
}

Error no_such_kiosk(const Museum& museum, std::string_view id,
                    const std::filesystem::path& database) {
  std::vector<std::string> ids;
  for (const KioskPlace& kiosk : museum.kiosks) ids.push_back(kiosk.id);
  return {Errc::InvalidInput,
          fmt::format("{}: has no kiosk '{}', which kiosk.toml says that this one is; {}",
                      database.string(), id,
                      ids.empty() ? std::string("its museum.toml names none")
                                  : fmt::format("it has {}", fmt::join(ids, ", ")))};
}

}  // namespace

Result<Selection> selection_of(const config::KioskConfig& config) {
  auto keys = signature::read_public_keys(config.keys);
  if (!keys) return std::unexpected(keys.error());
  return Selection{.keys = std::move(*keys), .kiosk = config.kiosk};
}

Result<Museum> read_museum(const std::filesystem::path& database, const Selection& selection,
                           ContentFacts* facts) {
  const Result<sqlite::Database> file = sqlite::open_database(database);
  if (!file) return std::unexpected(file.error());
  if (!selection.keys.empty())
    if (const auto trusted = sqlite::check_signature(*file, database, selection.keys); !trusted)
      return std::unexpected(trusted.error());
  Result<Museum> museum = sqlite::read_museum(*file, database);
  if (museum && museum->floors.empty())
    return std::unexpected(
        Error{Errc::Damaged, database.string() + ": it has no floor; recompile the content"});
  if (museum && !selection.kiosk.empty() && !stand_at(*museum, selection.kiosk))
    return std::unexpected(no_such_kiosk(*museum, selection.kiosk, database));
  if (museum && facts != nullptr)
    *facts = {.path = database,
              .museum = std::string(interface::in_language(*museum, 0, museum->title)),
              .checksum = sqlite::checksum_text(*file),
              .schema = schema::version,
              .signature = signed_by(*file, selection)};
  return museum;
}

std::string summary(const Museum& museum) {
  const auto many = [](std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
  };
  return fmt::format("'{}', {}, {}, {}", interface::in_language(museum, 0, museum.title),
                     many(museum.floors.size(), "floor"), many(museum.exhibits.size(), "exhibit"),
                     many(museum.languages.size(), "language"));
}

Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    const Selection& selection,
                                                    const guide::GuideSettings& settings) {
  ContentFacts content;
  Result<Museum> museum = read_museum(database, selection, &content);
  if (!museum) return std::unexpected(museum.error());
  Result<interface::SetText> set_text = pango::make_text_setter();
  if (!set_text) return std::unexpected(set_text.error());

  auto exhibition = std::make_unique<Exhibition>();
  exhibition->museum = std::move(*museum);
  exhibition->content = std::move(content);
  keep_what_is_walked(exhibition->museum);
  const Museum& kept = exhibition->museum;
  exhibition->scenery_pictures.resize(kept.images.size());
  auto pictures_made = make_scenery_pictures(kept, exhibition->scenery_pictures);
  interface::SetPicture set_picture = [&kept](std::uint32_t image, std::uint32_t width,
                                              std::uint32_t height) {
    return image::fill(decode(kept, image), width, height);
  };
  const guide::PlannerSize size = guide::planner_size(kept, settings);
  exhibition->planner = std::make_unique<plan::Planner>(
      kept, interface::PieceMakers{std::move(*set_text), std::move(set_picture)}, size.avatars,
      size.parts);
  exhibition->guide =
      std::make_unique<guide::Guide>(exhibition->museum, *exhibition->planner, settings);
  for (std::future<void>& made : pictures_made) made.get();
  return exhibition;
}

/// Pictures of the building have the first ids; the planner's pieces follow.
scene::TextureId scenery_texture(std::size_t image) noexcept {
  return static_cast<scene::TextureId>(1 + image);
}

void upload(Exhibition& exhibition, gles::Renderer& renderer) {
  for (std::size_t i = 0; i < exhibition.scenery_pictures.size(); ++i)
    renderer.upload_scenery_image(scenery_texture(i), exhibition.scenery_pictures[i]);
  exhibition.scenery_pictures = {};

  const Museum& museum = exhibition.museum;
  std::vector<scene::TextureId> picture_of;
  picture_of.reserve(museum.exhibits.size());
  for (const Exhibit& exhibit : museum.exhibits)
    picture_of.push_back(scenery_texture(exhibit.image));
  for (std::uint32_t i = 0; i < museum.scenery.size(); ++i)
    renderer.upload_scenery(i, museum.scenery[i], picture_of);
  renderer.upload_avatar(museum.avatar);
  // The renderer has its own copy of what is only drawn.
  exhibition.museum.scenery = {};
  exhibition.museum.avatar.vertices = {};
  exhibition.museum.avatar.indices = {};
}

bool apply_pieces(guide::Guide& guide, gles::Renderer& renderer) noexcept {
  bool changed = false;
  while (const std::unique_ptr<interface::PieceChanges> changes = guide.take_pieces()) {
    for (const scene::TextureId piece : changes->retired) renderer.release(piece);
    for (const auto& [piece, text, picture] : changes->uploads)
      if (picture.rgba.empty())
        renderer.upload_text(piece, text.width, text.height, text.coverage);
      else
        renderer.upload_image(piece, picture);
    changed = true;
  }
  return changed;
}

}  // namespace docent::kiosk
