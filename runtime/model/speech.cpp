#include "runtime/model/speech.h"

#include <algorithm>
#include <tuple>

namespace docent {

const SpeechSound* find_sound(std::span<const SpeechSound> speech, std::uint32_t language,
                              std::string_view text) noexcept {
  const auto wanted = std::tuple(language, text);
  const auto key = [](const SpeechSound& piece) {
    return std::tuple(piece.language, std::string_view(piece.text));
  };
  const auto found = std::ranges::lower_bound(speech, wanted, {}, key);
  return found != speech.end() && key(*found) == wanted ? &*found : nullptr;
}

}  // namespace docent
