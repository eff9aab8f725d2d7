#include "runtime/kiosk/poster.h"

#include <fmt/format.h>

#include <cstdlib>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

#include "platform/file/file_stamp.h"
#include "platform/file/read_file.h"
#include "platform/image/image.h"
#include "platform/terminal/command_line.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

PixelSize panel_size(const RenderTarget& target) noexcept {
  const bool sideways =
      target.rotation == Rotation::Quarter || target.rotation == Rotation::ThreeQuarters;
  return sideways ? PixelSize{target.size.height, target.size.width} : target.size;
}

/// Rows from the top, and opaque, of what OpenGL gives.
Pixels picture_of(std::span<const std::byte> frame, PixelSize size) {
  Pixels picture{size.width, size.height, {}};
  picture.rgba.reserve(frame.size());
  const std::size_t row = std::size_t{4} * size.width;
  for (std::size_t y = size.height; y-- > 0;) {
    const auto from = frame.subspan(y * row, row);
    picture.rgba.insert(picture.rgba.end(), from.begin(), from.end());
  }
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = std::byte{255};
  return picture;
}

std::string text_of(const file::FileStamp& stamp) {
  return fmt::format("{}-{}-{}.{:09}", stamp.number, stamp.size, stamp.seconds, stamp.nanoseconds);
}

std::filesystem::path path_of(const PosterFile& file) {
  return file.folder / "welcome.poster";
}

}  // namespace

PosterFile poster_file(const std::filesystem::path& database, const std::filesystem::path& settings,
                       Rotation rotation) {
  const char* const folder = std::getenv("CACHE_DIRECTORY");
  const file::FileStamp content = file::stamp_of(database);
  if (folder == nullptr || content == file::FileStamp{}) return {};
  return {.folder = folder,
          .key = fmt::format("docent {}, content {}, settings {}, turned {}", terminal::version(),
                             text_of(content), text_of(file::stamp_of(settings)),
                             90 * static_cast<int>(rotation))};
}

std::optional<Pixels> load_poster(const PosterFile& file, PixelSize size) {
  if (file.folder.empty()) return std::nullopt;
  const Result<std::string> text = file::read_file(path_of(file));
  if (!text || !text->starts_with(file.key + '\n')) return std::nullopt;
  const std::string_view png = std::string_view(*text).substr(file.key.size() + 1);
  Result<Pixels> picture = image::decode_image(std::as_bytes(std::span(png)));
  if (!picture || PixelSize{picture->width, picture->height} != size) return std::nullopt;
  return std::move(*picture);
}

PosterKeeper::PosterKeeper(PosterFile file, bool is_kept) : file_(std::move(file)) {
  if (file_.folder.empty() || is_kept) return;
  state_ = State::Wanted;
  writer_ = std::jthread([this] { wait_and_write(); });
}

PosterKeeper::~PosterKeeper() {
  // What waits for a frame is let go without one.
  for (State waiting : {State::Wanted, State::Asked})
    state_.compare_exchange_strong(waiting, State::Done);
  state_.notify_all();
}

void PosterKeeper::drawn(bool is_welcome, const RenderTarget& target) noexcept {
  if (state_ != State::Wanted || !is_welcome) return;
  frame_.begin(target.framebuffer, panel_size(target));
  state_ = State::Asked;
}

void PosterKeeper::step() noexcept {
  const State now = state_;
  if (now == State::Asked && !frame_.take().empty()) {
    state_ = State::Writing;
    state_.notify_all();
  }
  if (now == State::Done && frame_.is_begun()) frame_.end();
}

void PosterKeeper::wait_and_write() {
  for (State now = state_; now != State::Done; now = state_) {
    if (now != State::Writing) {
      state_.wait(now);
      continue;
    }
    guarded("keeping the first picture", [this] { write(); });
    state_ = State::Done;
  }
}

/// Where it cannot be written, the next start draws its first picture itself.
void PosterKeeper::write() {
  const auto png = image::encode_png(picture_of(frame_.take(), frame_.size()));
  if (!png) return;
  std::string text = file_.key + '\n';
  text.append(reinterpret_cast<const char*>(png->data()), png->size());
  std::ignore = write_whole(path_of(file_), text);
}

}  // namespace docent::kiosk
