#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "platform/display.h"
#include "platform/gles/read_back.h"
#include "runtime/model/pixels.h"

/// The first picture of a kiosk, as a run before drew it: it is on the screen while the program is
/// still being started, so that a visitor sees the welcome screen at once. The first frame, which
/// looks the same, takes its place.
namespace docent::kiosk {

/// Where it is kept, and what decides how it looks.
struct PosterFile {
  std::filesystem::path folder;  ///< Empty: it is not kept.
  std::string key;               ///< One line.
};

/// In the folder where the service manager lets the kiosk keep what can be made anew
/// ($CACHE_DIRECTORY), of this database, with these settings and on a screen that hangs like this.
PosterFile poster_file(const std::filesystem::path& database, const std::filesystem::path& settings,
                       Rotation rotation);

/// Rows from the top, as a screen of this size scans them out. Empty where none is kept, or one
/// that has another key or size or is damaged.
std::optional<Pixels> load_poster(const PosterFile& file, PixelSize size);

/// Keeps the first frame that may be a poster. For the frame thread, with its context current from
/// construction to destruction; a thread of its own writes.
class PosterKeeper {
 public:
  /// `is_kept`: what the next start shows is there already.
  PosterKeeper(PosterFile file, bool is_kept);
  ~PosterKeeper();
  PosterKeeper(const PosterKeeper&) = delete;
  PosterKeeper& operator=(const PosterKeeper&) = delete;

  /// A frame was drawn and will be presented. `is_welcome`: it is what the next visitor sees.
  /// Neither waits nor allocates.
  void drawn(bool is_welcome, const RenderTarget& target) noexcept;
  /// Goes on with what was asked of the driver; after each frame, drawn or not. Neither waits nor
  /// allocates.
  void step() noexcept;

 private:
  enum class State : std::uint8_t { Wanted, Asked, Writing, Done };
  void wait_and_write();
  void write();

  PosterFile file_;
  gles::ReadBack frame_;
  std::atomic<State> state_{State::Done};
  std::jthread writer_;
};

}  // namespace docent::kiosk
