#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "runtime/model/result.h"
#include "runtime/release/device_state.h"
#include "runtime/release/manifest.h"
#include "runtime/update/source.h"

namespace docent::update {

/// What lies on the disk, in the folder of the database that the kiosk shows:
///
///   museum.db                     the database shown: another name of the release's own file
///   update.state                  what the device remembers (release::DeviceState)
///   update.session                a TLS session of the source (https::Session); may be missing
///   update.lock                   held by whoever changes any of this
///   releases/000042-s7.db         release 42, for schema version 7: the last three, and of the
///                                 newest the ones that a newer program will show
///   releases/000042-s7.zck        the same, as zchunk fetched it: what the next is put together of
///
/// Everything is written beside its place, flushed and renamed. A new database is shown in this
/// order: its file is in `releases`; the state says that it is to be shown; museum.db is renamed
/// over; the state says that it is. Whoever finds the third undone does it.
struct Store {
  std::filesystem::path database;  ///< museum.db
};

/// Root becomes the owner of the store's folder for good, so that what a person does by hand leaves
/// nothing that the timer's own user could not change.
void become_owner(const Store& store) noexcept;

/// Nobody else changes the store while it lives.
class StoreLock {
 public:
  /// Waits for at most so many seconds; empty-handed after that.
  StoreLock(const Store& store, int seconds);
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;
  ~StoreLock();
  [[nodiscard]] bool is_held() const noexcept { return descriptor_ >= 0; }
  /// Why it is not held.
  [[nodiscard]] Error why() const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  int why_ = 0;  ///< errno; 0: somebody else holds it.
};

std::filesystem::path file_of(const Store& store, const release::Kept& kept);

/// A device that remembers nothing gets its place in rollouts here.
Result<release::DeviceState> load_state(const Store& store);
Result<void> save_state(const Store& store, const release::DeviceState& state);

/// Brings a file of a release into the store; one with the same bytes that is there already is not
/// fetched. Notes it in the state, which is not saved.
Result<release::Kept> keep(const Store& store, const Source& source, std::uint64_t version,
                           const release::ReleasedFile& file, release::DeviceState& state);

/// Shows a kept release from `now` on, in the order told above.
Result<void> show(const Store& store, const release::Kept& kept, release::DeviceState& state,
                  release::Time now);

/// Does what a power cut or a kill left undone.
Result<void> recover(const Store& store, release::DeviceState& state);

/// Lets go of releases that nobody goes back to, and of what was left half fetched.
void forget(const Store& store, release::DeviceState& state, std::uint32_t schema);

}  // namespace docent::update
