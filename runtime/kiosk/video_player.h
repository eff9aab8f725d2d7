#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

#include "platform/gles/holdings.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/model/blob_archive.h"
#include "runtime/model/pixels.h"
#include "runtime/model/result.h"
#include "runtime/video/fill_pixels.h"
#include "runtime/video/webm.h"

namespace docent::kiosk {

/// Plays a video in the texture of a picture: a thread reads it and decodes ahead into two frames
/// that were made when it began, and the frame thread carries the one that is due into texture
/// memory. The guide says how far the video has come; what comes too late is left out
/// (video::next_frame). Each coded frame is read from the file when it is decoded. One video is
/// played at a time, and all that it takes is given back when nobody watches it, and while it
/// stands at its beginning, which stays in the texture.
class VideoPlayer {
 public:
  /// `images`: where the museum's images lie, read by the thread alone; null: nothing is played.
  explicit VideoPlayer(std::shared_ptr<BlobArchive> images);
  ~VideoPlayer();
  VideoPlayer(const VideoPlayer&) = delete;
  VideoPlayer& operator=(const VideoPlayer&) = delete;

  /// A video of which a frame is to be seen, as large as its texture.
  struct Wish {
    std::uint32_t image = 0;
    scene::TextureId texture = scene::TextureId::None;
    gles::Holdings::Size size;
    float seconds = 0;  ///< Of the video. Less than before: it begins again.
    bool plays = true;  ///< Else it stands still.
  };
  /// Frame thread; these do not allocate. What is to be seen from now on.
  void want(const std::optional<Wish>& wish) noexcept;
  /// Puts the frame that is due into the texture; false where nothing changed.
  bool upload_next(gles::Holdings& holdings) noexcept;
  /// Is what is wanted at its end, or not to be played at all?
  bool has_ended() noexcept;
  /// Waits until what is due has been decoded: for runs that repeat exactly.
  void wait() noexcept;
  VideoCounters counters() noexcept;

 private:
  enum class SlotState : std::uint8_t { Free, Filling, Ready, Uploading };
  struct Slot {
    SlotState state = SlotState::Free;
    std::uint32_t milliseconds = 0;
    Pixels pixels;
  };
  struct Playing;  ///< What the thread has open.

  void work(const std::stop_token& stop);
  bool has_work() const noexcept;
  void open(std::unique_lock<std::mutex>& lock);
  std::unique_ptr<Playing> begun(std::uint32_t image) const;
  Result<video::Planes> decode(const video::Frame& frame);
  void close(std::unique_lock<std::mutex>& lock);
  void decode_next(std::unique_lock<std::mutex>& lock);
  Slot* slot_in(SlotState state) noexcept;
  bool fits_wish() const noexcept;
  bool rests() const noexcept;
  std::uint32_t due() const noexcept;

  std::shared_ptr<BlobArchive> images_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Wish> wish_{};        ///< By the frame thread.
  std::uint64_t run_ = 0;             ///< Grows with whatever is begun anew, somewhere.
  std::unique_ptr<Playing> playing_;  ///< The thread's; what it is of is read by both.
  std::uint64_t playing_run_ = 0;
  std::uint64_t shown_run_ = 0;  ///< That of which a frame was shown last, or could not be.
  std::optional<gles::Holdings::Size> made_for_{};
  std::size_t next_ = 0, frame_count_ = 0;
  std::uint32_t duration_ = 0;  ///< Milliseconds.
  std::uint32_t begun_at_ = 0;  ///< Likewise: what was due when it was opened.
  std::uint32_t seen_ = 0;      ///< Likewise: what was due when a frame was last made to be seen.
  bool is_open_ = false, has_failed_ = false, is_busy_ = false;
  std::array<Slot, 2> slots_;
  VideoCounters counters_;
  std::jthread thread_;
};

}  // namespace docent::kiosk
