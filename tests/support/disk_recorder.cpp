// Preloaded into a program, it stands between the program and the disk: it records what changes
// files below one folder, and kills the program, or lets the disk be full, at a chosen one of these
// operations. So every moment at which a kill or a power cut matters can be tried, one after
// another.
//
//   DOCENT_DISK_FOLDER   the folder
//   DOCENT_DISK_LOG      where the record goes: a line an operation, and the bytes of a write
//                        behind its line
//   DOCENT_DISK_KILL     the number of the operation before which the program is killed, from 1
//   DOCENT_DISK_FULL     the number of the operation from which on every write finds the disk full
//   DOCENT_DISK_FREE     how many bytes the disk says are free

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

bool is_watched(const char* path) {
  static const std::string folder = setting("DOCENT_DISK_FOLDER");
  return !folder.empty() && std::strncmp(path, folder.c_str(), folder.size()) == 0;
}

/// As the record names it, wherever the program is.
std::string absolute(int folder, const char* path) {
  if (*path == '/') return path;
  char link[64], there[PATH_MAX];
  std::snprintf(link, sizeof link, folder == AT_FDCWD ? "/proc/self/cwd" : "/proc/self/fd/%d",
                folder);
  const ssize_t size = readlink(link, there, sizeof there);
  return size > 0 ? std::string(there, static_cast<std::size_t>(size)) + '/' + path : path;
}
std::string absolute(const char* path) {
  return absolute(AT_FDCWD, path);
}

std::string path_of(int descriptor) {
  char link[64], path[PATH_MAX];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = readlink(link, path, sizeof path);
  return size > 0 ? std::string(path, static_cast<std::size_t>(size)) : std::string();
}

int number = 0;

/// Counts an operation, ends the program where that was asked for, and records it.
void record(const std::string& line, const void* bytes = nullptr, std::size_t size = 0) {
  static const int kill_at = std::atoi(setting("DOCENT_DISK_KILL"));
  static const std::string log = setting("DOCENT_DISK_LOG");
  if (++number == kill_at) raise(SIGKILL);
  if (log.empty()) return;
  static const int out = next<int(const char*, int, ...)>("open")(
      log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const auto write_all = next<ssize_t(int, const void*, std::size_t)>("write");
  const std::string head = line + "\n";
  if (write_all(out, head.data(), head.size()) < 0) abort();
  if (size > 0 && write_all(out, bytes, size) != static_cast<ssize_t>(size)) abort();
}

bool is_full() {
  static const int full_at = std::atoi(setting("DOCENT_DISK_FULL"));
  return full_at > 0 && number >= full_at;
}

}  // namespace

extern "C" {

int open(const char* named, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  const auto real = next<int(const char*, int, ...)>("open");
  const std::string whole = absolute(named);
  const char* const path = whole.c_str();
  if (!is_watched(path) || (flags & O_CREAT) == 0) return real(path, flags, mode);
  struct stat status{};
  const bool is_new = stat(path, &status) != 0;
  if (is_new || (flags & O_TRUNC) != 0) record(std::string("create ") + path);
  return real(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return open(path, flags, mode);
}
ssize_t write(int descriptor, const void* bytes, std::size_t size) {
  const std::string path = path_of(descriptor);
  if (is_watched(path.c_str())) {
    const off_t at = lseek(descriptor, 0, SEEK_CUR);
    record("write " + std::to_string(size) + " " + std::to_string(at) + " " + path, bytes, size);
    if (is_full()) return errno = ENOSPC, -1;
  }
  return next<ssize_t(int, const void*, std::size_t)>("write")(descriptor, bytes, size);
}
int fsync(int descriptor) {
  const std::string path = path_of(descriptor);
  if (is_watched(path.c_str())) record("fsync " + path);
  return next<int(int)>("fsync")(descriptor);
}
int rename(const char* from, const char* to) {
  if (is_watched(to)) record(std::string("rename ") + from + " " + to);
  return next<int(const char*, const char*)>("rename")(from, to);
}
int link(const char* from, const char* to) {
  if (is_watched(to)) record(std::string("link ") + from + " " + to);
  return next<int(const char*, const char*)>("link")(from, to);
}
int unlink(const char* path) {
  struct stat status{};
  if (is_watched(path) && stat(path, &status) == 0) record(std::string("unlink ") + path);
  return next<int(const char*)>("unlink")(path);
}
int unlinkat(int folder, const char* named, int flags) {
  struct stat status{};
  const std::string path = absolute(folder, named);
  if (is_watched(path.c_str()) && (flags & AT_REMOVEDIR) == 0 && stat(path.c_str(), &status) == 0)
    record("unlink " + path);
  return next<int(int, const char*, int)>("unlinkat")(folder, named, flags);
}
int ftruncate(int descriptor, off_t size) {
  const std::string path = path_of(descriptor);
  if (is_watched(path.c_str())) record("truncate " + std::to_string(size) + " " + path);
  return next<int(int, off_t)>("ftruncate")(descriptor, size);
}
int remove(const char* path) {
  struct stat status{};
  if (is_watched(path) && stat(path, &status) == 0) record(std::string("unlink ") + path);
  return next<int(const char*)>("remove")(path);
}
/// What a program that is limited in the size of its files writes is in the record too, which grows
/// beyond that.
int setrlimit(__rlimit_resource_t what, const struct rlimit* limit) {
  if (what == RLIMIT_FSIZE) return 0;
  return next<int(__rlimit_resource_t, const struct rlimit*)>("setrlimit")(what, limit);
}
int setrlimit64(__rlimit_resource_t what, const struct rlimit64* limit) {
  return setrlimit(what, reinterpret_cast<const struct rlimit*>(limit));  // the same on 64 bits
}
int statvfs(const char* path, struct statvfs* says) {
  const int result = next<int(const char*, struct statvfs*)>("statvfs")(path, says);
  const char* const free = setting("DOCENT_DISK_FREE");
  if (result != 0 || *free == '\0' || !is_watched(path)) return result;
  says->f_bavail = static_cast<fsblkcnt_t>(std::strtoull(free, nullptr, 10) / says->f_frsize);
  return 0;
}
int statvfs64(const char* path, struct statvfs64* says) {
  return statvfs(path, reinterpret_cast<struct statvfs*>(says));  // the same on 64 bits
}
int mkdir(const char* path, mode_t mode) {
  struct stat status{};
  if (is_watched(path) && stat(path, &status) != 0) record(std::string("mkdir ") + path);
  return next<int(const char*, mode_t)>("mkdir")(path, mode);
}

}  // extern "C"
