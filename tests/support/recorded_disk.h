#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/run_program.h"

namespace docent::test {

/// One operation of a program on the disk, as disk_recorder.cpp records it.
struct DiskOperation {
  std::string kind;  ///< create write truncate fsync rename link unlink mkdir
  std::string path, to;
  std::size_t at = 0;  ///< Where a write begins; what a truncated file keeps.
  std::string bytes;   ///< Of a write.
};

inline std::vector<DiskOperation> read_operations(const std::filesystem::path& log) {
  std::vector<DiskOperation> operations;
  std::ifstream in(log, std::ios::binary);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    DiskOperation operation;
    words >> operation.kind;
    if (operation.kind == "write") {
      std::size_t size = 0;
      words >> size >> operation.at;
      operation.bytes.resize(size);
      in.read(operation.bytes.data(), static_cast<std::streamsize>(size));
    }
    if (operation.kind == "truncate") words >> operation.at;
    words >> operation.path >> operation.to;
    operations.push_back(std::move(operation));
  }
  return operations;
}

/// A disk that tells what has reached it for good from what has not: the bytes of a file do with
/// its fsync, its names with that of their folder. Names change in the order in which they were
/// changed, as journals keep it.
class RecordedDisk {
 public:
  /// Begins with what lies in the folder.
  explicit RecordedDisk(const std::filesystem::path& folder) : folder_(folder) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      // Names of one file stay names of one file.
      const auto inode = inode_of(entry.path());
      if (!known_.contains(inode)) {
        known_[inode] = files_.size();
        const std::string bytes = text_of(entry.path());
        files_.push_back({bytes, bytes});
      }
      names_[entry.path().string()] = known_[inode];
    }
    durable_names_ = names_;
  }

  void apply(const DiskOperation& operation) {
    const std::string& path = operation.path;
    if (operation.kind == "create") {
      if (names_.contains(path)) {
        files_[names_[path]].bytes.clear();
        return;
      }
      files_.emplace_back();
      change([path, file = files_.size() - 1](Names& names) { names[path] = file; });
    } else if (operation.kind == "write") {
      std::string& bytes = files_[names_.at(path)].bytes;
      bytes.resize(std::max(bytes.size(), operation.at + operation.bytes.size()));
      bytes.replace(operation.at, operation.bytes.size(), operation.bytes);
    } else if (operation.kind == "truncate") {
      files_[names_.at(path)].bytes.resize(operation.at);
    } else if (operation.kind == "fsync") {
      if (names_.contains(path)) {
        File& file = files_[names_.at(path)];
        file.durable = file.bytes;
      } else {
        durable_names_ = names_;
        pending_.clear();
      }
    } else if (operation.kind == "rename") {
      change([operation](Names& names) {
        names[operation.to] = names.at(operation.path);
        names.erase(operation.path);
      });
    } else if (operation.kind == "link") {
      change([operation](Names& names) { names[operation.to] = names.at(operation.path); });
    } else if (operation.kind == "unlink") {
      change([path](Names& names) { names.erase(path); });
    }
  }

  enum class Bytes : std::uint8_t { All, OnlySynced };

  /// How many states of its names a power cut may leave.
  std::size_t cuts() const { return pending_.size() + 1; }

  /// Writes what a power cut leaves into another folder: the first so many of the changes of names
  /// that no fsync has made last, and of each file all bytes or only those that were synced.
  void write_after_cut(std::size_t changes, Bytes bytes, const std::filesystem::path& to) const {
    Names names = durable_names_;
    for (std::size_t i = 0; i < changes; ++i) pending_[i](names);
    std::filesystem::remove_all(to);
    std::map<std::size_t, std::filesystem::path> written;
    for (const auto& [path, file] : names) {
      const std::filesystem::path name = to / std::filesystem::relative(path, folder_);
      std::filesystem::create_directories(name.parent_path());
      if (const auto other = written.find(file); other != written.end()) {
        std::filesystem::create_hard_link(other->second, name);
        continue;
      }
      std::ofstream(name, std::ios::binary)
          << (bytes == Bytes::All ? files_[file].bytes : files_[file].durable);
      written[file] = name;
    }
  }

 private:
  using Names = std::map<std::string, std::size_t>;
  struct File {
    std::string bytes, durable;
  };
  static std::uintmax_t inode_of(const std::filesystem::path& path) {
    struct ::stat status{};
    ::stat(path.c_str(), &status);
    return status.st_ino;
  }
  void change(auto&& how) {
    how(names_);
    pending_.emplace_back(how);
  }

  std::filesystem::path folder_;
  std::map<std::uintmax_t, std::size_t> known_;
  std::vector<File> files_;
  Names names_, durable_names_;
  std::vector<std::function<void(Names&)>> pending_;
};

/// Runs one of our programs with the recorder between it and the folder; `settings` are those of
/// disk_recorder.cpp, "DOCENT_DISK_KILL=3".
inline ProgramRun run_recorded(const char* name, const std::string& arguments,
                               const std::filesystem::path& folder, const std::string& settings) {
  const TemporaryFolder out;
  const std::filesystem::path recorder = program("libdisk_recorder.so");
  const std::string command = fmt::format(
      "env ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='{}' DOCENT_DISK_FOLDER='{}' {} '{}' "
      "{} >'{}/out' 2>'{}/err'",
      recorder.string(), folder.string(), settings, program(name).string(), arguments,
      out.path().string(), out.path().string());
  const int status = std::system(command.c_str());  // NOLINT(bugprone-command-processor)
  // The shell tells of a kill as 128 and the signal.
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 137;
  return {.exit_code = code == 137 ? -1 : code,
          .out = text_of(out.path() / "out"),
          .err = text_of(out.path() / "err")};
}

}  // namespace docent::test
