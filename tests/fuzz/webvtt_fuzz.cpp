#include <cstddef>
#include <cstdint>
#include <string_view>

#include "content/import/caption/webvtt.h"
#include "runtime/model/exhibit/longer_text.h"

/// Captions of anybody's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace docent::import;
  const CaptionFile file =
      read_webvtt(std::string_view(reinterpret_cast<const char*>(data), size), "film.vtt");
  if (file.captions.empty() && file.faults.empty()) __builtin_trap();
  for (const docent::Diagnostic& fault : file.faults)
    if (fault.message.empty() || fault.hint.empty() || fault.code.empty()) __builtin_trap();
  for (const TimedCaption& one : file.captions)
    if (one.begin >= one.end || one.text.empty() || one.line == 0 ||
        docent::count_letters(one.text) > most_caption_letters)
      __builtin_trap();
  std::uint32_t end = 0;
  for (const TimedCaption& one : one_at_a_time(file.captions)) {
    if (one.begin < end || one.end <= one.begin || one.text.empty()) __builtin_trap();
    end = one.end;
  }
  return 0;
}
