// A stand-in for pcaudiolib, which plays espeak-ng's sound. Ours is written to docent-content
// instead of played, and the real one has 28 libraries loaded, for every piece that is said: half
// of the time that espeak-ng takes to begin. The functions are those of pcaudiolib/audio.h.
#include <cstddef>
#include <cstdint>

extern "C" {

// NOLINTBEGIN(readability-identifier-naming): the names and the types are theirs.
struct audio_object;

audio_object* create_audio_device_object(const char*, const char*, const char*) {
  return nullptr;
}
int audio_object_open(audio_object*, int, std::uint32_t, std::uint8_t) {
  return -1;
}
void audio_object_close(audio_object*) {}
void audio_object_destroy(audio_object*) {}
int audio_object_write(audio_object*, const void*, std::size_t) {
  return 0;
}
int audio_object_drain(audio_object*) {
  return 0;
}
int audio_object_flush(audio_object*) {
  return 0;
}
const char* audio_object_strerror(audio_object*, int) {
  return "";
}
// NOLINTEND(readability-identifier-naming)
}
