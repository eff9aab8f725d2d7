#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/kiosk_config.h"
#include "platform/gles/holdings.h"
#include "platform/signature/key.h"
#include "runtime/guide/guide.h"
#include "runtime/kiosk/kiosk_status.h"
#include "runtime/kiosk/object_details.h"
#include "runtime/kiosk/today_watch.h"
#include "runtime/kiosk/video_player.h"
#include "runtime/model/blob_archive.h"
#include "runtime/model/museum.h"
#include "runtime/model/result.h"
#include "runtime/plan/planner.h"
#include "runtime/scene/body_detail.h"

namespace docent::kiosk {

/// A museum with everything that runs it: replaced as a whole by a new database. Neither copied nor
/// moved, because its parts borrow each other.
struct Exhibition {
  Museum museum;
  ContentFacts content;
  interface::SetText set_text;          ///< In the museum's letters.
  std::shared_ptr<BlobArchive> sounds;  ///< Null: all of the museum's are in memory.
  std::unique_ptr<plan::Planner> planner;
  std::unique_ptr<guide::Guide> guide;
  std::unique_ptr<TodayWatch> today;
  gles::Holdings holdings;
  std::unique_ptr<ObjectDetails> details;  ///< Null where no exhibit is a shape of its own.
  /// As many as the guide has players; none where no exhibit has a video.
  std::vector<std::unique_ptr<VideoPlayer>> videos;
  /// By image, with their smaller ones, until they are in texture memory.
  std::vector<std::vector<Pixels>> scenery_pictures;
  scene::BodyLevels body_levels;  ///< Likewise.
  std::size_t uploaded = 0;  ///< Of its pictures, buildings, objects and its body, in this order.
  bool is_uploaded = false;  ///< All of them.

  Exhibition() = default;
  Exhibition(const Exhibition&) = delete;
  Exhibition& operator=(const Exhibition&) = delete;
};

/// What a device shows.
struct Selection {
  std::vector<signature::PublicKey> keys{};  ///< Where there are any, only what is signed with one.
  std::string kiosk{};            ///< Which of the museum's kiosks it is; empty: the first.
  std::filesystem::path today{};  ///< What is closed just now; empty: nothing.
  bool is_simulated = false;      ///< A run that repeats exactly, without a clock.
};
/// As the settings say; fails where a key cannot be read.
Result<Selection> selection_of(const config::KioskConfig& config);

/// A museum, and the database that it was read from.
struct ReadMuseum {
  Museum museum;
  ContentFacts content;
};
/// Reads a museum that can be shown, as this device shows it, but for its videos, which stay in the
/// file. Fails with a sentence.
Result<ReadMuseum> read_museum(const std::filesystem::path& database, const Selection& selection);
/// What a museum is, in a line for the journal: its title and how much it holds.
std::string summary(const Museum& museum);

/// Makes all of it ready. Takes a while, so do not call on the frame thread.
Result<std::unique_ptr<Exhibition>> make_exhibition(ReadMuseum read, const Selection& selection,
                                                    const guide::GuideSettings& settings);
/// Reads a database, and that.
Result<std::unique_ptr<Exhibition>> load_exhibition(const std::filesystem::path& database,
                                                    const Selection& selection,
                                                    const guide::GuideSettings& settings);

/// Carries one more of the exhibition's pictures, one more megabyte of a building or the body into
/// texture memory, so that it can be done between frames; false where nothing was left. Frame
/// thread.
bool upload_next(Exhibition& exhibition);
/// All of them.
void upload(Exhibition& exhibition);

/// Fetches the object that is looked at, or about to be, from nearby; false where nothing changed.
/// Frame thread; does not allocate. `waits`: until it has been read.
bool look_at_object(Exhibition& exhibition, std::optional<std::uint32_t> object,
                    bool waits) noexcept;

/// By player of the guide: the texture in which the frame that is due of a video is shown; None
/// where nothing changed.
using PlayedIn = std::array<scene::TextureId, guide::VideoTurns::most>;
/// Shows what is due of the videos that visitors watch. Frame thread; does not allocate. `waits`:
/// until it has been decoded.
PlayedIn play_videos(Exhibition& exhibition, bool waits) noexcept;
/// What all of its players have counted.
VideoCounters video_counters(const Exhibition& exhibition) noexcept;

/// Applies what the worker's cache of pieces changed; false where that is nothing. Frame thread;
/// does not allocate.
bool apply_pieces(Exhibition& exhibition) noexcept;

}  // namespace docent::kiosk
