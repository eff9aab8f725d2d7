#include "runtime/kiosk/object_details.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/kiosk/allocations.h"
#include "runtime/schema/object_blob.h"

namespace docent::kiosk {
namespace {

/// Texels of all of an object's pictures: on the screen it has no more pixels.
constexpr double most_texels = 600'000;

std::vector<std::vector<Pixels>> decoded(const std::vector<std::vector<std::byte>>& files) {
  std::vector<Pixels> pictures;
  double texels = 0;
  for (const std::vector<std::byte>& file : files) {
    pictures.push_back(image::decode_image(file).value_or(Pixels{}));
    texels += static_cast<double>(pictures.back().width) * pictures.back().height;
  }
  const double share = texels > most_texels ? std::sqrt(most_texels / texels) : 1;
  std::vector<std::vector<Pixels>> levels;
  for (Pixels& picture : pictures) {
    const auto side =
        static_cast<std::uint32_t>(std::max(1.0, share * std::max(picture.width, picture.height)));
    levels.push_back(image::mip_levels(image::shrink(std::move(picture), side)));
  }
  return levels;
}

}  // namespace

ObjectDetails::ObjectDetails(Read read)
    : read_{std::move(read)}, thread_{[this](const std::stop_token& stop) { work(stop); }} {}

ObjectDetails::~ObjectDetails() {
  thread_.request_stop();
  changed_.notify_all();
  thread_.join();
}

ObjectDetails::Ready ObjectDetails::read(std::uint32_t object) const {
  Ready ready{.object = object, .detail = {}, .pictures = {}};
  // What cannot be read any more is shown as it is from afar.
  if (!schema::decode(read_(object), ready.detail)) return ready;
  ready.pictures = decoded(ready.detail.pictures);
  ready.detail.pictures = {};
  return ready;
}

void ObjectDetails::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [&] { return has_freed_ || (wanted_ && wanted_ != done_); })) {
    if (has_freed_) {
      has_freed_ = false;
      lock.unlock();
      give_back_freed_memory();
      lock.lock();
      continue;
    }
    const std::uint32_t object = *wanted_;
    lock.unlock();
    Ready ready = read(object);
    lock.lock();
    done_ = object;
    if (wanted_ == object) ready_ = std::move(ready);
    changed_.notify_all();
  }
}

void ObjectDetails::want(std::optional<std::uint32_t> object) noexcept {
  if (object == asked_) return;
  asked_ = object;
  const std::scoped_lock lock(mutex_);
  wanted_ = object;
  changed_.notify_all();
  if (object == shown_) return;
  done_.reset();
  ready_.reset();
}

void ObjectDetails::wait() noexcept {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !wanted_ || wanted_ == done_; });
}

bool ObjectDetails::upload_next(gles::Holdings& holdings) noexcept {
  if (asked_ != shown_ && shown_) {
    holdings.drop_object_detail();
    shown_.reset();
    tell_of_freed_memory();
    return true;
  }
  if (!uploading_ || uploading_->object != asked_) {
    uploading_.reset();
    uploaded_ = 0;
    if (!asked_ || asked_ == shown_) return false;
    const std::scoped_lock lock(mutex_);
    if (!ready_) return false;
    uploading_ = std::exchange(ready_, std::nullopt);
    if (uploading_->object != asked_) return false;
  }
  if (uploaded_ == 0)
    holdings.begin_object_detail(uploading_->detail);
  else
    holdings.add_object_picture(uploaded_ - 1, uploading_->pictures[uploaded_ - 1]);
  if (uploaded_++ < uploading_->pictures.size()) return true;
  holdings.show_object_detail(uploading_->object);
  shown_ = uploading_->object;
  uploading_.reset();
  uploaded_ = 0;
  tell_of_freed_memory();
  return true;
}

/// What was read lies in texture memory now, or nowhere: the thread has the time to return it.
void ObjectDetails::tell_of_freed_memory() noexcept {
  const std::scoped_lock lock(mutex_);
  has_freed_ = true;
  changed_.notify_all();
}

}  // namespace docent::kiosk
