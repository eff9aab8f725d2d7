#include "runtime/kiosk/transcript.h"

#include <fmt/format.h>

namespace docent::kiosk {
namespace {

std::string field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string transcript_line(double time, const guide::Saying& saying) {
  if (saying.utterance == nullptr) return {};
  return fmt::format("{:.3f},{},{},{}\n", time, field(saying.control),
                     field(saying.utterance->language),
                     field(interface::text_of(*saying.utterance)));
}

std::string transcript_line(double time, const guide::PlayedSound& sound, const Museum& museum,
                            std::uint32_t language) {
  const ExhibitSound& played = museum.sounds[sound.sound];
  const auto first = sounds_of(museum, played.exhibit).data();
  const std::string text =
      fmt::format("[{}]", interface::in_language(museum, language, played.title));
  return fmt::format("{:.3f},sound:{},{},{}\n", time, &played - first + 1,
                     field(museum.languages[language].tag), field(text));
}

}  // namespace docent::kiosk
