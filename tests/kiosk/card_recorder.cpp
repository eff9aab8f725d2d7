// Preloaded into a program, it stands between the program and its graphics card: it writes down
// when a picture is committed and when it is shown, and has the card fail as cards do.
//
//   DOCENT_CARD_FOLDER   where the record goes (`commits`), and where files ask for trouble, which
//                        may come and go while the program runs:
//     busy               while it is there, every commit is refused: another one is under way
//     lose-flip          the next flip is never told of, and the file is taken away
//     hang               the next commit never returns
//
// A line of the record is a time of the monotonic clock in nanoseconds, and what happened then:
// `set` (a mode setting that waits), `commit`, `refused`, `flip`, `lost`, `busy` or `hang`, and the
// error's number or 0.

#include <dlfcn.h>
#include <drm.h>
#include <fcntl.h>
#include <time.h>
#include <unistd.h>
#include <xf86drmMode.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

template <typename Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::string in_folder(const char* name) {
  const char* folder = std::getenv("DOCENT_CARD_FOLDER");
  return std::string(folder != nullptr ? folder : "/nonexistent") + "/" + name;
}

int card = -1;  ///< The descriptor of the last commit.

void record(const char* what, int number = 0) {
  static const std::string path = in_folder("commits");
  static const int out = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  char line[64];
  const int size = std::snprintf(line, sizeof line, "%lld%09ld %s %d\n",
                                 static_cast<long long>(now.tv_sec), now.tv_nsec, what, number);
  if (write(out, line, static_cast<std::size_t>(size)) < 0) std::abort();
}

bool is_asked_for(const char* trouble) {
  return access(in_folder(trouble).c_str(), F_OK) == 0;
}

/// Takes the flips out of what was read; returns how many bytes are left.
ssize_t without_flips(char* events, ssize_t size) {
  ssize_t kept = 0;
  for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(drm_event)) <= size;) {
    drm_event head{};
    std::memcpy(&head, events + at, sizeof head);
    if (head.type != DRM_EVENT_FLIP_COMPLETE) {
      std::memmove(events + kept, events + at, head.length);
      kept += head.length;
    }
    at += head.length;
  }
  return kept;
}

}  // namespace

extern "C" {

int drmModeAtomicCommit(int fd, const drmModeAtomicReqPtr request, std::uint32_t flags,
                        void* data) {
  static const auto real =
      next<int(int, const drmModeAtomicReqPtr, std::uint32_t, void*)>("drmModeAtomicCommit");
  if ((flags & DRM_MODE_ATOMIC_TEST_ONLY) != 0) return real(fd, request, flags, data);
  card = fd;
  if (is_asked_for("busy")) {
    record("busy");
    return -EBUSY;
  }
  if (is_asked_for("hang")) {
    record("hang");
    for (;;) pause();
  }
  const int status = real(fd, request, flags, data);
  if (status == 0)
    record("commit");
  else
    record("refused", -status);
  return status;
}

int drmModeSetCrtc(int fd, std::uint32_t crtc, std::uint32_t buffer, std::uint32_t x,
                   std::uint32_t y, std::uint32_t* connectors, int count, drmModeModeInfoPtr mode) {
  static const auto real = next<decltype(drmModeSetCrtc)>("drmModeSetCrtc");
  const int status = real(fd, crtc, buffer, x, y, connectors, count, mode);
  record("set");
  return status;
}

ssize_t read(int fd, void* bytes, std::size_t count) {
  static const auto real = next<ssize_t(int, void*, std::size_t)>("read");
  const ssize_t size = real(fd, bytes, count);
  if (fd != card || size <= 0) return size;
  if (is_asked_for("lose-flip")) {
    const ssize_t left = without_flips(static_cast<char*>(bytes), size);
    if (left == size) return size;
    record("lost");
    unlink(in_folder("lose-flip").c_str());
    if (left > 0) return left;
    errno = EAGAIN;
    return -1;
  }
  record("flip");
  return size;
}

}  // extern "C"
