#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "platform/gles/holdings.h"
#include "platform/image/image.h"
#include "runtime/model/exhibit/object.h"

namespace docent::kiosk {

/// Fetches what an object is from nearby when somebody comes to it: a thread reads it and decodes
/// its pictures, and the frame thread carries it into texture memory a piece at a time. One
/// object's is kept.
class ObjectDetails {
 public:
  /// The bytes of an object's detail, valid until the next call; called by the thread alone.
  using Read = std::function<std::span<const std::byte>(std::uint32_t object)>;

  explicit ObjectDetails(Read read);
  ~ObjectDetails();
  ObjectDetails(const ObjectDetails&) = delete;
  ObjectDetails& operator=(const ObjectDetails&) = delete;

  /// What is looked at, or about to be, from now on. Frame thread; does not allocate.
  void want(std::optional<std::uint32_t> object) noexcept;
  /// One more piece of it, or the removal of what nobody looks at; false where nothing changed.
  /// Frame thread; does not allocate.
  bool upload_next(gles::Holdings& holdings) noexcept;
  /// Waits until what is wanted has been read: for runs that repeat exactly.
  void wait() noexcept;

 private:
  /// An object that has been read.
  struct Ready {
    std::uint32_t object = 0;
    ObjectDetail detail;
    std::vector<std::vector<Pixels>> pictures;  ///< With their smaller ones.
  };
  void work(const std::stop_token& stop);
  Ready read(std::uint32_t object) const;
  void tell_of_freed_memory() noexcept;

  Read read_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<std::uint32_t> wanted_{};  ///< By the frame thread.
  std::optional<std::uint32_t> done_{};    ///< Read last, or in vain.
  std::optional<Ready> ready_{};
  bool has_freed_ = false;  ///< The frame thread: much memory since.
  // The frame thread's own.
  std::optional<Ready> uploading_{};
  std::size_t uploaded_ = 0;  ///< Pieces: the shape, then its pictures.
  std::optional<std::uint32_t> asked_{}, shown_{};
  std::jthread thread_;
};

}  // namespace docent::kiosk
