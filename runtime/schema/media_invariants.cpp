#include "runtime/schema/media_invariants.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

#include "runtime/model/exhibit/longer_text.h"

namespace docent::schema {
namespace {

/// Those of an exhibit lie together, and are not too many to leaf through.
bool keep(const std::vector<FurtherPicture>& pictures, const Museum& museum) {
  const auto is_there = [&](const FurtherPicture& picture) {
    return picture.exhibit < museum.exhibits.size() && picture.image < museum.images.size() &&
           further_pictures(museum, picture.exhibit).size() < FurtherPicture::most;
  };
  return std::ranges::is_sorted(pictures, {}, &FurtherPicture::exhibit) &&
         std::ranges::all_of(pictures, is_there);
}

/// Those of a video or a sound, `of`, in a language follow each other, and are no more than a kiosk
/// sets.
template <typename Timed>
bool keep_time(const std::vector<Timed>& cues, std::uint32_t Timed::* of, std::size_t there,
               const Museum& museum) {
  const auto is_sound = [&](const Timed& cue) {
    return cue.*of < there && cue.language < museum.languages.size() && cue.begin < cue.end &&
           cue.end <= Timed::latest && !cue.text.empty() &&
           count_letters(cue.text) <= Timed::most_letters;
  };
  const auto are_together = [&](const Timed& a, const Timed& b) {
    return a.*of == b.*of && a.language == b.language;
  };
  const auto comes_before = [&](const Timed& a, const Timed& b) {
    return are_together(a, b) ? a.end <= b.begin
                              : std::tie(a.*of, a.language) < std::tie(b.*of, b.language);
  };
  if (!std::ranges::all_of(cues, is_sound) ||
      std::ranges::adjacent_find(cues, std::not_fn(comes_before)) != cues.end())
    return false;
  for (std::size_t i = Timed::most; i < cues.size(); ++i)
    if (are_together(cues[i], cues[i - Timed::most])) return false;
  return true;
}

/// Those of an exhibit lie together, are not too many to choose from, and each can be heard.
bool keep(const std::vector<ExhibitSound>& sounds, const Museum& museum) {
  const auto is_there = [&](const ExhibitSound& sound) {
    const auto index = static_cast<std::uint32_t>(&sound - sounds.data());
    const SpeechSound* recording = recording_of(museum, index, 0);
    return sound.exhibit < museum.exhibits.size() && recording != nullptr &&
           sounds_of(museum, sound.exhibit).size() <= ExhibitSound::most;
  };
  return std::ranges::is_sorted(sounds, {}, &ExhibitSound::exhibit) &&
         std::ranges::all_of(sounds, is_there);
}

/// Can each piece be found and played to its end?
bool keeps_speech(const std::vector<SpeechSound>& speech, std::size_t languages) {
  const auto sound = [=](const SpeechSound& piece) {
    const auto held = samples_of_packets(piece.packets);
    constexpr std::uint32_t longest = SpeechSound::rate * ExhibitSound::longest;
    if (is_recording(piece) && piece.samples > longest) return false;
    return piece.language < languages && piece.samples > 0 && held &&
           *held >= std::uint64_t{piece.skip} + piece.samples;
  };
  const auto in_order = [](const SpeechSound& a, const SpeechSound& b) {
    return std::tie(a.language, a.text) < std::tie(b.language, b.text);
  };
  return std::ranges::all_of(speech, sound) &&
         std::ranges::adjacent_find(speech, std::not_fn(in_order)) == speech.end();
}

}  // namespace

std::string broken_media(const Museum& museum) {
  if (!keep(museum.pictures, museum)) return "the exhibits' further pictures";
  if (!keep_time(museum.cues, &Cue::picture, museum.pictures.size(), museum))
    return "the captions of its videos";
  if (!keeps_speech(museum.speech, museum.languages.size())) return "its speech";
  if (!keep(museum.sounds, museum)) return "its sounds";
  if (!keep_time(museum.sound_cues, &SoundCue::sound, museum.sounds.size(), museum))
    return "the captions of its sounds";
  return {};
}

}  // namespace docent::schema
