#include "runtime/kiosk/video_player.h"

#include <algorithm>
#include <utility>

#include "platform/vpx/decoder.h"
#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/video/next_frame.h"

namespace docent::kiosk {

namespace {

std::uint32_t milliseconds(const VideoPlayer::Wish& wish) noexcept {
  return static_cast<std::uint32_t>(1000 * std::clamp(wish.seconds, 0.0F, 3600.0F));
}

}  // namespace

struct VideoPlayer::Playing {
  std::uint32_t image;
  video::Video video;
  vpx::Decoder decoder;
  std::vector<std::byte> coded;  ///< As long as the longest frame.
};

VideoPlayer::VideoPlayer(std::shared_ptr<BlobArchive> images)
    : images_{std::move(images)}, thread_{[this](const std::stop_token& stop) { work(stop); }} {}

VideoPlayer::~VideoPlayer() {
  thread_.request_stop();
  changed_.notify_all();
  thread_.join();
}

// The thread's side. The mutex is held but for reading and decoding.

bool VideoPlayer::fits_wish() const noexcept {
  return wish_ && is_open_ && playing_run_ == run_;
}

/// Does it stand at its beginning, which has been shown?
bool VideoPlayer::rests() const noexcept {
  return wish_ && !wish_->plays && wish_->seconds <= 0 && shown_run_ == run_;
}

std::uint32_t VideoPlayer::due() const noexcept {
  return milliseconds(*wish_);
}

VideoPlayer::Slot* VideoPlayer::slot_in(SlotState state) noexcept {
  const auto slot = std::ranges::find(slots_, state, &Slot::state);
  return slot == slots_.end() ? nullptr : &*slot;
}

bool VideoPlayer::has_work() const noexcept {
  if (!wish_ || rests()) return is_open_;
  if (!fits_wish()) return true;
  return !has_failed_ && next_ < frame_count_ &&
         std::ranges::find(slots_, SlotState::Free, &Slot::state) != slots_.end();
}

void VideoPlayer::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [&] { return has_work(); })) {
    is_busy_ = true;
    if (!wish_ || rests())
      close(lock);
    else if (!fits_wish())
      open(lock);
    else
      decode_next(lock);
    is_busy_ = false;
    changed_.notify_all();
  }
}

void VideoPlayer::close(std::unique_lock<std::mutex>& lock) {
  is_open_ = false;
  made_for_.reset();
  lock.unlock();
  playing_.reset();
  if (images_) images_->let_go();
  lock.lock();
  for (Slot& slot : slots_)
    if (slot.state != SlotState::Uploading) slot = {};
  lock.unlock();
  give_back_freed_memory();
  lock.lock();
}

/// Null where it cannot be played. All of its bytes are in memory only while its frames are looked
/// for.
std::unique_ptr<VideoPlayer::Playing> VideoPlayer::begun(std::uint32_t image) const {
  if (!images_) return {};
  Result<video::Video> video = video::read_webm(images_->read(image));
  images_->let_go();
  if (!video || video::beyond(*video)) return {};
  Result<vpx::Decoder> decoder = vpx::Decoder::open(*video);
  if (!decoder) return {};
  const std::size_t longest = std::ranges::max(video->frames, {}, &video::Frame::size).size;
  return std::make_unique<Playing>(Playing{.image = image,
                                           .video = std::move(*video),
                                           .decoder = std::move(*decoder),
                                           .coded = std::vector<std::byte>(longest)});
}

/// Fails where the file no longer has what it had.
Result<video::Planes> VideoPlayer::decode(const video::Frame& frame) {
  const std::span<std::byte> coded = std::span(playing_->coded).first(frame.size);
  if (!images_->read_part(playing_->image, frame.at, coded))
    return std::unexpected(Error{Errc::Damaged, "a frame cannot be read"});
  return playing_->decoder.decode(coded);
}

void VideoPlayer::open(std::unique_lock<std::mutex>& lock) {
  const Wish wish = *wish_;
  const std::uint64_t run = run_;
  // Whoever uploads is quick, and a frame's memory must not go meanwhile.
  changed_.wait(lock, [&] { return slot_in(SlotState::Uploading) == nullptr; });
  for (Slot& slot : slots_) slot.state = SlotState::Filling;
  lock.unlock();
  playing_.reset();
  playing_ = begun(wish.image);
  if (made_for_ != wish.size)
    for (Slot& slot : slots_)
      slot.pixels = {wish.size.width, wish.size.height,
                     std::vector<std::byte>(std::size_t{4} * wish.size.width * wish.size.height)};
  lock.lock();
  for (Slot& slot : slots_) slot.state = SlotState::Free;
  is_open_ = true;
  playing_run_ = run;
  made_for_ = wish.size;
  begun_at_ = seen_ = milliseconds(wish);
  has_failed_ = playing_ == nullptr;
  if (has_failed_) shown_run_ = run;
  // What lies before is nobody's loss.
  next_ = has_failed_ ? 0 : video::next_frame(playing_->video.frames, 0, seen_, seen_).index;
  frame_count_ = has_failed_ ? 0 : playing_->video.frames.size();
  duration_ = has_failed_ ? 0 : static_cast<std::uint32_t>(playing_->video.duration().count());
}

void VideoPlayer::decode_next(std::unique_lock<std::mutex>& lock) {
  const std::span<const video::Frame> frames = playing_->video.frames;
  const video::NextFrame next = video::next_frame(frames, next_, due(), seen_);
  const video::Frame frame = frames[next.index];
  const auto is_lost = [&](const video::Frame& one) {
    return one.is_shown && one.milliseconds >= begun_at_;
  };
  const auto passed = frames.subspan(next_, next.index - next_);
  counters_.dropped += static_cast<std::size_t>(std::ranges::count_if(passed, is_lost));
  next_ = next.index + 1;
  if (next.is_seen) seen_ = due();
  Slot* slot = slot_in(SlotState::Free);
  slot->state = SlotState::Filling;
  lock.unlock();
  const std::chrono::nanoseconds began = thread_cpu_now();
  const Result<video::Planes> planes = decode(frame);
  const bool is_seen = planes && planes->y != nullptr && next.is_seen;
  if (is_seen) video::fill_pixels(*planes, slot->pixels);
  const std::chrono::nanoseconds took = thread_cpu_now() - began;
  lock.lock();
  counters_.decoding += took;
  ++counters_.decoded;
  if (!next.is_seen && is_lost(frame)) ++counters_.dropped;
  if (!planes) {
    has_failed_ = true;
    shown_run_ = playing_run_;
  }
  slot->milliseconds = frame.milliseconds;
  slot->state = is_seen && fits_wish() ? SlotState::Ready : SlotState::Free;
}

// The frame thread's side.

void VideoPlayer::want(const std::optional<Wish>& wish) noexcept {
  const std::scoped_lock lock(mutex_);
  if (!wish && !wish_) return;
  const bool begins =
      wish && (!wish_ || wish_->image != wish->image || wish_->texture != wish->texture ||
               wish_->size != wish->size || wish->seconds < wish_->seconds);
  const bool goes_on = wish && wish_ && wish->plays != wish_->plays;
  wish_ = wish;
  if (begins) ++run_;
  if (begins || goes_on || !wish) changed_.notify_all();
}

bool VideoPlayer::upload_next(gles::Holdings& holdings) noexcept {
  Slot* newest = nullptr;
  scene::TextureId texture{};
  {
    const std::scoped_lock lock(mutex_);
    if (!fits_wish()) return false;
    texture = wish_->texture;
    for (Slot& slot : slots_) {
      if (slot.state != SlotState::Ready || slot.milliseconds > due()) continue;
      Slot* older = newest;
      if (newest != nullptr && newest->milliseconds > slot.milliseconds)
        older = &slot;
      else
        newest = &slot;
      if (older == nullptr) continue;
      older->state = SlotState::Free;
      ++counters_.dropped;
    }
    if (newest == nullptr) return false;
    newest->state = SlotState::Uploading;
    changed_.notify_all();
  }
  holdings.replace_image(texture, newest->pixels);
  const std::scoped_lock lock(mutex_);
  newest->state = SlotState::Free;
  shown_run_ = run_;
  ++counters_.shown;
  changed_.notify_all();
  return true;
}

bool VideoPlayer::has_ended() noexcept {
  const std::scoped_lock lock(mutex_);
  return fits_wish() && (has_failed_ || due() >= duration_);
}

void VideoPlayer::wait() noexcept {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !is_busy_ && !has_work(); });
}

VideoCounters VideoPlayer::counters() noexcept {
  const std::scoped_lock lock(mutex_);
  return counters_;
}

}  // namespace docent::kiosk
