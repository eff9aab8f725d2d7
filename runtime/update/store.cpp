#include "runtime/update/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>
#include <set>
#include <thread>

#include "platform/file/read_file.h"
#include "platform/file/write_file.h"
#include "platform/signature/digest.h"
#include "runtime/update/delta.h"

namespace docent::update {
namespace {

namespace fs = std::filesystem;
using release::DeviceState;
using release::Kept;

constexpr std::size_t kept_releases = 3;
constexpr std::size_t largest_state = 65536;

fs::path folder_of(const Store& store) {
  return store.database.has_parent_path() ? store.database.parent_path() : ".";
}
fs::path state_file(const Store& store) {
  return folder_of(store) / "update.state";
}
fs::path releases_folder(const Store& store) {
  return folder_of(store) / "releases";
}

std::unexpected<Error> failure(const fs::path& file, std::string_view what, int why) {
  return std::unexpected(Error{
      Errc::Environment,
      fmt::format("{}: {} ({}); what is shown stays", file.string(), what, std::strerror(why))});
}

/// A file as it is fetched: beside its place, gone again unless it is whole.
class Download {
 public:
  explicit Download(const fs::path& file)
      : file_(file),
        part_(file.string() + ".part"),
        descriptor_(::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
    if (descriptor_ < 0) why_ = errno;
  }
  Download(const Download&) = delete;
  Download& operator=(const Download&) = delete;
  ~Download() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (descriptor_ >= 0 && !is_kept_) ::unlink(part_.c_str());
  }

  [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
  [[nodiscard]] int why() const noexcept { return why_; }

  bool add(std::span<const std::byte> bytes) {
    digest_.add(bytes);
    size_ += bytes.size();
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return why_ = errno, false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }
  bool is(const release::ReleasedFile& file) {
    return size_ == file.size && digest_.finish() == file.hash;
  }
  bool keep() {
    if (::fchmod(descriptor_, 0644) != 0 || ::fsync(descriptor_) != 0 ||
        std::rename(part_.c_str(), file_.c_str()) != 0)
      return why_ = errno, false;
    is_kept_ = true;
    file::flush_folder(file_.parent_path());
    return true;
  }

 private:
  fs::path file_, part_;
  int descriptor_;
  int why_ = 0;
  std::uint64_t size_ = 0;
  signature::Digest digest_;
  bool is_kept_ = false;
};

Result<void> fetch_whole(const Source& source, const release::ReleasedFile& file,
                         const fs::path& place) {
  Download download(place);
  if (!download.is_open()) return failure(place, "cannot be written", download.why());
  const Result<https::Response> fetched =
      fetch(source, file.name, file.size, {},
            [&](std::span<const std::byte> bytes) { return download.add(bytes); });
  if (download.why() != 0) return failure(place, "cannot be written", download.why());
  if (!fetched) return std::unexpected(fetched.error());
  const std::string name = name_in(source, file.name);
  if (fetched->kind == https::Response::Kind::NotFound)
    return std::unexpected(Error{
        Errc::Environment, fmt::format("{}: is not there, though its release lists it", name)});
  if (!download.is(file))
    return std::unexpected(
        Error{Errc::InvalidInput,
              fmt::format("{}: is not the file that its release lists; it is not taken", name)});
  if (!download.keep()) return failure(place, "cannot be written", download.why());
  return {};
}

fs::path zchunk_of(fs::path database) {
  return database.replace_extension(".zck");
}

/// Brings the file by its differences from the newest kept one of the same schema version; false
/// where that did not work, for whatever reason.
bool fetch_differences(const Store& store, const Source& source, const release::ReleasedFile& file,
                       const DeviceState& state, const fs::path& place) {
  if (!is_url(source)) return false;
  const Kept* const older = release::newest_kept(state, file.schema);
  DeltaFiles files;
  const bool fetched =
      fetch_delta({.url = name_in(source, file.name),
                   .most = file.size,
                   .older = older != nullptr ? zchunk_of(file_of(store, *older)) : fs::path(),
                   .folder = releases_folder(store) / "parts"},
                  files);
  // What zchunk made is copied as any other source is, and so verified and flushed.
  const bool kept = fetched && fetch_whole({files.file.parent_path().string()}, file, place);
  std::error_code ignored;
  if (kept) fs::rename(files.zchunk, zchunk_of(place), ignored);
  fs::remove_all(releases_folder(store) / "parts", ignored);
  return kept;
}

/// Is there room for a file, and for what else a kiosk writes meanwhile? A full disk would hurt
/// more than one that keeps an old release.
Result<void> check_room(const Store& store, const release::ReleasedFile& file,
                        std::uint64_t version) {
  constexpr std::uint64_t for_others = 8U << 20U;
  const fs::path folder = releases_folder(store);
  std::error_code status;
  const std::uint64_t room = fs::space(folder, status).available;
  if (status || (room >= for_others && file.size <= room - for_others)) return {};
  return std::unexpected(
      Error{Errc::Environment,
            fmt::format("{}: has {} MB of room, and release {} needs {}; what is shown stays",
                        folder.string(), room >> 20U, version, (file.size + for_others) >> 20U)});
}

Result<void> fetch_new(const Store& store, const Source& source, const release::ReleasedFile& file,
                       const DeviceState& state, const fs::path& place, std::uint64_t version) {
  if (const Result<void> fits = check_room(store, file, version); !fits) return fits;
  if (fetch_differences(store, source, file, state, place)) return {};
  return fetch_whole(source, file, place);
}

/// A kept file with these bytes, by another release's name.
bool link_same(const Store& store, const release::ReleasedFile& file, const DeviceState& state,
               const fs::path& place) {
  const auto same = std::ranges::find(state.kept, file.hash, &Kept::hash);
  if (same == state.kept.end()) return false;
  const fs::path there = file_of(store, *same);
  const Result<std::string> hash = signature::digest_of(there);
  if (!hash || *hash != file.hash) return false;
  if (there == place) return true;
  ::unlink(place.c_str());
  if (::link(there.c_str(), place.c_str()) != 0) return false;
  file::flush_folder(place.parent_path());
  return true;
}

Result<void> put_in_place(const Store& store, const Kept& kept) {
  const fs::path from = file_of(store, kept), beside = store.database.string() + ".new";
  ::unlink(beside.c_str());
  if (::link(from.c_str(), beside.c_str()) != 0 ||
      std::rename(beside.c_str(), store.database.c_str()) != 0)
    return failure(store.database, "cannot be replaced", errno);
  // Two names of one file: rename() then does nothing, and leaves both.
  ::unlink(beside.c_str());
  file::flush_folder(folder_of(store));
  return {};
}

}  // namespace

StoreLock::StoreLock(const Store& store, int seconds) : file_(folder_of(store) / "update.lock") {
  const int descriptor = ::open(file_.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) why_ = errno;
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
  while (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (std::chrono::steady_clock::now() >= until) {
      ::close(descriptor);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  descriptor_ = descriptor;
}

Error StoreLock::why() const {
  if (why_ != 0) return failure(file_, "cannot be written", why_).error();
  return {Errc::Environment,
          fmt::format("{}: another docent-update is at work; try again", file_.string())};
}

void become_owner(const Store& store) noexcept {
  struct stat status{};
  if (::geteuid() != 0 || ::stat(folder_of(store).c_str(), &status) != 0 || status.st_uid == 0)
    return;
  // In this order: whoever is no longer root cannot change his groups. Where it fails, he is root.
  if (::setgroups(0, nullptr) == 0 && ::setgid(status.st_gid) == 0)
    static_cast<void>(::setuid(status.st_uid) == 0);
}

StoreLock::~StoreLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

fs::path file_of(const Store& store, const Kept& kept) {
  return releases_folder(store) / fmt::format("{:06}-s{}.db", kept.version, kept.schema);
}

Result<DeviceState> load_state(const Store& store) {
  const fs::path file = state_file(store);
  if (!file::is_there(file)) {
    std::random_device random;
    DeviceState state;
    state.portion = std::uniform_real_distribution<double>(0, 1)(random);
    return state;
  }
  const Result<std::string> text = file::read_file(file, largest_state);
  if (!text) return std::unexpected(text.error());
  return release::parse_state(*text, file);
}

Result<void> save_state(const Store& store, const DeviceState& state) {
  const std::string text = release::to_text(state);
  return file::replace_file(state_file(store), std::as_bytes(std::span(text)));
}

Result<Kept> keep(const Store& store, const Source& source, std::uint64_t version,
                  const release::ReleasedFile& file, DeviceState& state) {
  Kept kept{.version = version, .schema = file.schema, .hash = file.hash};
  const fs::path place = file_of(store, kept);
  std::error_code status;
  fs::create_directories(releases_folder(store), status);
  if (status) return failure(releases_folder(store), "cannot be made", status.value());
  if (!link_same(store, file, state, place))
    if (const Result<void> fetched = fetch_new(store, source, file, state, place, version);
        !fetched)
      return std::unexpected(fetched.error());
  if (std::ranges::find(state.kept, kept) == state.kept.end()) state.kept.push_back(kept);
  return kept;
}

Result<void> show(const Store& store, const Kept& kept, DeviceState& state, release::Time now) {
  state.shown = kept.version;
  state.shown_schema = kept.schema;
  state.shown_since = now;
  state.starts.clear();
  state.is_pending = true;
  if (const Result<void> saved = save_state(store, state); !saved) return saved;
  if (const Result<void> placed = put_in_place(store, kept); !placed) return placed;
  state.is_pending = false;
  return save_state(store, state);
}

Result<void> recover(const Store& store, DeviceState& state) {
  if (!state.is_pending && file::is_there(store.database)) return {};
  const auto kept = std::ranges::find_if(state.kept, [&](const Kept& each) {
    return each.version == state.shown && each.schema == state.shown_schema;
  });
  if (kept == state.kept.end()) return {};
  if (const Result<void> placed = put_in_place(store, *kept); !placed) return placed;
  state.is_pending = false;
  return save_state(store, state);
}

void forget(const Store& store, DeviceState& state, std::uint32_t schema) {
  std::ranges::sort(state.kept, std::greater(), &Kept::version);
  std::set<std::uint64_t> versions;
  const std::uint64_t newest = state.kept.empty() ? 0 : state.kept.front().version;
  std::erase_if(state.kept, [&](const Kept& kept) {
    if (kept.version == state.shown) return false;
    if (kept.schema > schema) return kept.version != newest;
    if (versions.size() >= kept_releases - 1) return !versions.contains(kept.version);
    versions.insert(kept.version);
    return false;
  });
  if (!save_state(store, state)) return;  // then nothing is removed that the old one names
  std::set<fs::path> named;
  for (const Kept& kept : state.kept) {
    named.insert(file_of(store, kept));
    named.insert(zchunk_of(file_of(store, kept)));
  }
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(releases_folder(store), ignored))
    if (!named.contains(entry.path())) fs::remove_all(entry.path(), ignored);
}

}  // namespace docent::update
