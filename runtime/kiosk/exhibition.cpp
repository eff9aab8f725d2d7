#include "runtime/kiosk/exhibition.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "platform/image/image.h"
#include "platform/pango/text_setter.h"
#include "platform/sqlite/content_reader.h"
#include "platform/sqlite/file_archive.h"
#include "platform/sqlite/signature_block.h"
#include "platform/vpx/decoder.h"
#include "runtime/interface/control.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/model/moving_picture.h"
#include "runtime/model/scenery_images.h"
#include "runtime/plan/order_tours.h"
#include "runtime/schema/schema.h"

namespace docent::kiosk {
namespace {

/// Its pixels, none where it cannot be decoded.
Pixels decode(std::span<const std::byte> bytes, bool is_video) {
  if (is_video) return vpx::first_picture(bytes).value_or(Pixels{});
  return image::decode_image(bytes).value_or(Pixels{});
}

/// A picture that cannot be decoded is left out: its exhibit is shown without one. `archive`: where
/// it lies; null: in memory.
Pixels picture_of(const Museum& museum, BlobArchive* archive, std::uint32_t image) {
  if (image >= museum.images.size()) return {};
  const EncodedImage& encoded = museum.images[image];
  if (archive == nullptr) return decode(encoded.bytes, is_video(encoded));
  Pixels pixels = decode(archive->read(image), is_video(encoded));
  archive->let_go();
  return pixels;
}

/// By image: does it hang in the model? Of what stands there as a thing it does not.
std::vector<bool> hung_images(const Museum& museum, std::size_t images) {
  std::vector<bool> hung(images);
  for (const Exhibit& exhibit : museum.exhibits)
    if (exhibit.object < 0 && exhibit.image < images) hung[exhibit.image] = true;
  return hung;
}

/// Makes the pictures of the building, on other processors while the rest of the start goes on.
/// `pictures` has one for each of those images, empty where none hangs, and stays where it is until
/// all are made.
std::vector<std::future<void>> make_scenery_pictures(const Museum& museum,
                                                     std::span<std::vector<Pixels>> pictures) {
  const std::uint32_t side = scenery_image_side(pictures.size());
  const std::size_t at_a_time = std::clamp(std::thread::hardware_concurrency(), 1U, 4U);
  std::vector<std::future<void>> made;
  for (std::size_t first = 0; first < at_a_time; ++first)
    made.push_back(std::async(std::launch::async, [&museum, pictures, side, first, at_a_time] {
      const std::vector<bool> hung = hung_images(museum, pictures.size());
      for (std::size_t i = first; i < pictures.size(); i += at_a_time) {
        if (!hung[i]) continue;
        const EncodedImage& image = museum.images[i];
        const auto& bytes = image.small.empty() ? image.bytes : image.small;
        pictures[i] = image::mip_levels(
            image::shrink(image::decode_at_least(bytes, side).value_or(Pixels{}), side));
      }
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

/// Seconds since 1970; 0 where nobody knows.
double written_at(const std::filesystem::path& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error) return 0;
  return std::chrono::duration<double>(std::chrono::file_clock::to_sys(time).time_since_epoch())
      .count();
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

/// Pictures of the building have the first ids; the planner's pieces follow.
scene::TextureId scenery_texture(std::size_t image) noexcept {
  return static_cast<scene::TextureId>(1 + image);
}

/// Some more of it; false once all is there.
bool upload_building(Exhibition& exhibition, std::uint32_t floor) {
  const Museum& museum = exhibition.museum;
  std::vector<scene::TextureId> picture_of;
  picture_of.reserve(museum.exhibits.size());
  for (const Exhibit& exhibit : museum.exhibits)
    picture_of.push_back(scenery_texture(exhibit.image));
  return exhibition.holdings.add_scenery(floor, museum.scenery[floor], picture_of);
}

/// What is only drawn has a copy in texture memory, from there on.
void forget_what_is_uploaded(Exhibition& exhibition) {
  exhibition.scenery_pictures.clear();
  exhibition.body_levels = {};
  exhibition.museum.scenery.clear();
  for (ExhibitObject& object : exhibition.museum.objects) object.distant = {};
  // Whole, because a vector that is given an empty list keeps its memory.
  SkinnedMesh& body = exhibition.museum.avatar;
  body = SkinnedMesh{.vertices = {},
                     .indices = {},
                     .figure_end = std::move(body.figure_end),
                     .inverse_bind = std::move(body.inverse_bind),
                     .cloth = std::move(body.cloth)};
}

}  // namespace

Result<Selection> selection_of(const config::KioskConfig& config) {
  auto keys = signature::read_public_keys(config.keys);
  if (!keys) return std::unexpected(keys.error());
  return Selection{.keys = std::move(*keys), .kiosk = config.kiosk};
}

Result<ReadMuseum> read_museum(const std::filesystem::path& database, const Selection& selection) {
  const Result<sqlite::Database> file = sqlite::open_database(database, schema::largest_shown);
  if (!file) return std::unexpected(file.error());
  if (!selection.keys.empty())
    if (const auto trusted = sqlite::check_signature(*file, database, selection.keys); !trusted)
      return std::unexpected(trusted.error());
  Result<Museum> museum = sqlite::read_museum(*file, database, sqlite::Videos::LeaveInFile);
  if (!museum) return std::unexpected(museum.error());
  if (museum->floors.empty())
    return std::unexpected(
        Error{Errc::Damaged, database.string() + ": it has no floor; recompile the content"});
  if (!selection.kiosk.empty() && !stand_at(*museum, selection.kiosk))
    return std::unexpected(no_such_kiosk(*museum, selection.kiosk, database));
  if (museum && !museum->kiosks.empty() && museum->kiosks.front().id != selection.kiosk)
    plan::order_tours(*museum);
  ContentFacts facts{.path = database,
                     .museum = std::string(interface::in_language(*museum, 0, museum->title)),
                     .checksum = sqlite::checksum_text(*file),
                     .schema = schema::version,
                     .signature = signed_by(*file, selection),
                     .written = written_at(database)};
  return ReadMuseum{.museum = std::move(*museum), .content = std::move(facts)};
}

std::string summary(const Museum& museum) {
  const auto many = [](std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
  };
  return fmt::format("'{}', {}, {}, {}", interface::in_language(museum, 0, museum.title),
                     many(museum.floors.size(), "floor"), many(museum.exhibits.size(), "exhibit"),
                     many(museum.languages.size(), "language"));
}

namespace {

/// Minutes of speech are heard by few visitors, a sentence at a time: they are read when they are
/// said. Null, and the sounds stay in memory, where the file is not what it was.
std::shared_ptr<BlobArchive> leave_sounds_on_disk(const ContentFacts& content,
                                                  std::vector<SpeechSound>& speech) {
  if (speech.empty()) return {};
  std::shared_ptr<BlobArchive> archive =
      sqlite::open_archive(content.path, sqlite::Archived::Speech, content.checksum);
  if (!archive) return {};
  // Copies lie close together; what is emptied in its place leaves holes too small to give back.
  std::vector<SpeechSound> light;
  light.reserve(speech.size());
  for (const SpeechSound& sound : speech)
    light.push_back({.language = sound.language,
                     .text = sound.text,
                     .made_of = {},
                     .skip = sound.skip,
                     .samples = sound.samples,
                     .packets = {},
                     .archived = static_cast<std::uint32_t>(light.size())});
  speech = std::move(light);
  return archive;
}

/// Objects as they are from nearby stay in the file, but for where it is not what it was.
std::unique_ptr<ObjectDetails> details_of(Exhibition& exhibition) {
  std::vector<ExhibitObject>& objects = exhibition.museum.objects;
  if (objects.empty()) return {};
  std::shared_ptr<BlobArchive> archive = sqlite::open_archive(
      exhibition.content.path, sqlite::Archived::Objects, exhibition.content.checksum);
  if (!archive)
    return std::make_unique<ObjectDetails>([&objects](std::uint32_t object) {
      return std::span<const std::byte>(objects[object].detail);
    });
  // Not an empty list, which a vector keeps its memory for.
  for (ExhibitObject& object : objects) object.detail = std::vector<std::byte>();
  return std::make_unique<ObjectDetails>(
      [archive](std::uint32_t object) { return archive->read(object); });
}

std::vector<std::unique_ptr<VideoPlayer>> video_players(const Exhibition& exhibition) {
  std::vector<std::unique_ptr<VideoPlayer>> players;
  if (std::ranges::none_of(exhibition.museum.images, is_video)) return players;
  for (std::size_t i = 0; i < exhibition.guide->players(); ++i)
    players.push_back(std::make_unique<VideoPlayer>(sqlite::open_archive(
        exhibition.content.path, sqlite::Archived::Images, exhibition.content.checksum)));
  return players;
}

}  // namespace

Result<std::unique_ptr<Exhibition>> make_exhibition(ReadMuseum read, const Selection& selection,
                                                    const guide::GuideSettings& settings) {
  Result<interface::SetText> set_text = pango::make_text_setter(&read.museum);
  if (!set_text) return std::unexpected(set_text.error());

  auto exhibition = std::make_unique<Exhibition>();
  exhibition->museum = std::move(read.museum);
  exhibition->content = std::move(read.content);
  exhibition->set_text = *set_text;
  keep_what_is_walked(exhibition->museum);
  exhibition->sounds = leave_sounds_on_disk(exhibition->content, exhibition->museum.speech);
  const Museum& kept = exhibition->museum;
  exhibition->scenery_pictures.resize(scenery_images(kept));
  auto pictures_made = make_scenery_pictures(kept, exhibition->scenery_pictures);
  // Pictures as they came are read when the worker sets one; null, and they stay in memory.
  const std::shared_ptr<BlobArchive> pictures = sqlite::open_archive(
      exhibition->content.path, sqlite::Archived::Images, exhibition->content.checksum);
  interface::SetPicture set_picture = [&kept, pictures](std::uint32_t image, std::uint32_t width,
                                                        std::uint32_t height) {
    return image::fill(picture_of(kept, pictures.get(), image), width, height);
  };
  // What visitors of the last hours needed is not kept for months.
  const auto rest = [] {
    pango::forget_letters();
    give_back_freed_memory();
  };
  const guide::PlannerSize size = guide::planner_size(kept, settings);
  exhibition->planner = std::make_unique<plan::Planner>(
      kept, interface::PieceMakers{std::move(*set_text), std::move(set_picture), rest},
      size.avatars, size.parts);
  exhibition->guide =
      std::make_unique<guide::Guide>(exhibition->museum, *exhibition->planner, settings);
  exhibition->today = std::make_unique<TodayWatch>(
      kept,
      [&planner = *exhibition->planner](const Closures& closures) { planner.close(closures); },
      selection.today, selection.is_simulated);
  exhibition->body_levels = scene::levels_of(kept.avatar);
  exhibition->details = details_of(*exhibition);
  exhibition->videos = video_players(*exhibition);
  for (std::future<void>& made : pictures_made) made.get();
  exhibition->museum.fonts.clear();  // the setter has them
  for (EncodedImage& image : exhibition->museum.images) {
    image.small = {};
    if (pictures) image.bytes = {};
  }
  give_back_freed_memory();  // What the making took, as long as another museum is shown beside it.
  return exhibition;
}

Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    const Selection& selection,
                                                    const guide::GuideSettings& settings) {
  Result<ReadMuseum> read = read_museum(database, selection);
  if (!read) return std::unexpected(read.error());
  return make_exhibition(std::move(*read), selection, settings);
}

bool upload_next(Exhibition& exhibition) {
  if (exhibition.is_uploaded) return false;
  const std::size_t pictures = exhibition.scenery_pictures.size();
  const std::size_t floors = exhibition.museum.scenery.size();
  const std::size_t objects = exhibition.museum.objects.size();
  const std::size_t next = exhibition.uploaded;
  bool is_whole = true;
  if (next < pictures) {
    if (!exhibition.scenery_pictures[next].empty())
      exhibition.holdings.add_scenery_image(scenery_texture(next),
                                            exhibition.scenery_pictures[next]);
  } else if (next < pictures + floors) {
    is_whole = !upload_building(exhibition, static_cast<std::uint32_t>(next - pictures));
  } else if (next < pictures + floors + objects) {
    const std::size_t index = next - pictures - floors;
    const ExhibitObject& object = exhibition.museum.objects[index];
    exhibition.holdings.add_object(static_cast<std::uint32_t>(index), object.size, object.distant);
  } else {
    exhibition.holdings.set_body(exhibition.museum.avatar, exhibition.body_levels);
    forget_what_is_uploaded(exhibition);
    exhibition.is_uploaded = true;
  }
  exhibition.uploaded += is_whole ? 1 : 0;
  return true;
}

void upload(Exhibition& exhibition) {
  while (upload_next(exhibition)) {
  }
}

bool look_at_object(Exhibition& exhibition, std::optional<std::uint32_t> object,
                    bool waits) noexcept {
  if (!exhibition.details || !exhibition.is_uploaded) return false;
  exhibition.details->want(object);
  if (waits) exhibition.details->wait();
  return exhibition.details->upload_next(exhibition.holdings);
}

namespace {

scene::TextureId play_video(Exhibition& exhibition, std::size_t player, bool waits) noexcept {
  constexpr auto none = scene::TextureId::None;
  VideoPlayer& video = *exhibition.videos[player];
  const std::optional<guide::ShownVideo> shown = exhibition.guide->video(player);
  const auto size = shown ? exhibition.holdings.size_of(shown->texture) : gles::Holdings::Size{};
  if (size == gles::Holdings::Size{}) {
    video.want({});
    return none;
  }
  video.want(VideoPlayer::Wish{.image = shown->image,
                               .texture = shown->texture,
                               .size = size,
                               .seconds = shown->seconds,
                               .plays = shown->plays});
  if (waits) video.wait();
  const bool has_changed = video.upload_next(exhibition.holdings);
  if (video.has_ended()) exhibition.guide->video_ended(player);
  return has_changed ? shown->texture : none;
}

}  // namespace

PlayedIn play_videos(Exhibition& exhibition, bool waits) noexcept {
  PlayedIn changed{};
  for (std::size_t i = 0; i < exhibition.videos.size(); ++i)
    changed[i] = play_video(exhibition, i, waits);
  return changed;
}

VideoCounters video_counters(const Exhibition& exhibition) noexcept {
  VideoCounters all;
  for (const auto& player : exhibition.videos) all += player->counters();
  return all;
}

bool apply_pieces(Exhibition& exhibition) noexcept {
  gles::Holdings& holdings = exhibition.holdings;
  bool changed = false;
  while (const std::unique_ptr<interface::PieceChanges> changes = exhibition.guide->take_pieces()) {
    for (const scene::TextureId piece : changes->retired) holdings.release(piece);
    for (const auto& [piece, text, picture] : changes->uploads)
      if (picture.rgba.empty())
        holdings.add_text(piece, text.width, text.height, text.coverage);
      else
        holdings.add_image(piece, picture);
    changed = true;
  }
  return changed;
}

}  // namespace docent::kiosk
