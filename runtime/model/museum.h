#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/connection.h"
#include "runtime/model/exhibit/cue.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/model/exhibit/exhibit_sound.h"
#include "runtime/model/geometry/floor.h"
#include "runtime/model/livery.h"
#include "runtime/model/motion/motion_graph.h"
#include "runtime/model/motion/skinned_mesh.h"
#include "runtime/model/place.h"
#include "runtime/model/scenery.h"
#include "runtime/model/speech.h"
#include "runtime/model/tour.h"
#include "runtime/model/way_offer.h"

namespace docent {

/// A picture, kept as the bytes of a PNG or JPEG file.
struct EncodedImage {
  std::string name;
  std::uint32_t width = 0, height = 0;  ///< Pixels.
  std::vector<std::byte> bytes;
  /// The same as it hangs in the model (scenery_images.h), likewise; empty where it never does, or
  /// where it is as small as that.
  std::vector<std::byte> small{};
};

/// A language the kiosk speaks.
struct Language {
  std::string tag;   ///< BCP 47.
  std::string name;  ///< In the language itself: "English", "中文", "العربية".
  bool right_to_left = false;
  std::map<std::string, std::string, std::less<>> words;  ///< The interface's words by key.
};

/// The strollers: they walk about on the kiosk's floor and look at exhibits.
struct Ambient {
  static constexpr std::uint32_t most = 56;    ///< With eight guides 64: no more are drawn.
  static constexpr double longest_look = 600;  ///< Seconds.

  std::uint32_t count = 0;  ///< At most `most`. A quiet museum has none.
  /// Where they come from, floor frame: points that have room for a body, each with a way to the
  /// kiosk. Empty: they are there already, spread over the viewing points of the exhibits.
  std::vector<Vec2> entrances;
  /// Seconds that one stands and looks. 0 < look_least <= look_most <= longest_look.
  double look_least = 6, look_most = 20;
};

/// One of several kiosks that share a museum.
struct KioskPlace {
  std::string id;
  std::uint32_t floor = 0;
  Placement placement;
};

/// Everything the kiosk knows, as the database holds it. Immutable once loaded.
struct Museum {
  LocalText title;
  LocalText welcome;
  std::string time_zone;  ///< Of all hours, as time_zone.h reads it; empty: the kiosk's own.
  std::string holidays;   ///< Public ones, as parse_dates reads them; empty: none.
  std::vector<Language> languages;  ///< The first is the default.
  Livery livery;
  std::vector<FontFile> fonts;  ///< Of the livery's typefaces.
  std::vector<Floor> floors;
  std::vector<Connection> connections;
  std::vector<Place> places;
  std::vector<WayOffer> ways;    ///< In the order of their buttons, each once; none: all there are.
  std::vector<Scenery> scenery;  ///< One per floor: what is drawn of it.
  std::vector<Room> rooms;
  std::vector<Exhibit> exhibits;
  std::vector<FurtherPicture> pictures;  ///< In the order of their exhibits.
  std::vector<Cue> cues;  ///< By picture, language and time; of a video never two at once.
  std::vector<ExhibitSound> sounds;  ///< In the order of their exhibits.
  std::vector<SoundCue> sound_cues;  ///< By sound, language and time; never two at once.
  std::vector<Tour> tours;
  /// How titles and names are read that are not typed as they are written: Chinese in Pinyin,
  /// Japanese in kana, syllables with spaces between them. By the text.
  std::map<std::string, std::string, std::less<>> readings;
  std::vector<EncodedImage> images;
  std::vector<ExhibitObject> objects;
  /// By language and text, each once; none: it is silent. Also the recordings of `sounds`, by
  /// recording_key().
  std::vector<SpeechSound> speech;
  std::uint32_t kiosk_floor = 0;
  Placement kiosk;  ///< "You are here"; the heading is where the visitor looks.
  /// Where they have names: all of them, the first being the one above. stand_at() changes that.
  std::vector<KioskPlace> kiosks;
  double body_radius = 0.25;  ///< Metres.
  /// A walking body rounds corners a little inside its way, so ways are asked for with this much
  /// room to spare. Metres.
  static constexpr double walking_room = 0.02;
  Ambient ambient;
  MotionGraph motion;  ///< Without clips where the museum was compiled with --no-motion.
  SkinnedMesh avatar;
};

/// Has staff given it a picture? Else a blank one stands in for it.
[[nodiscard]] inline bool has_picture(const Museum& museum, const Exhibit& exhibit) noexcept {
  return exhibit.image < museum.images.size() && !museum.images[exhibit.image].name.empty();
}

/// The pictures that one leafs to from the exhibit's own, in that order.
[[nodiscard]] inline std::span<const FurtherPicture> further_pictures(
    const Museum& museum, std::uint32_t exhibit) noexcept {
  const auto of_it =
      std::ranges::equal_range(museum.pictures, exhibit, {}, &FurtherPicture::exhibit);
  return {of_it.begin(), of_it.end()};
}

/// What is read below that picture, a video, in a language: their own, else the first of the
/// museum's in which there is any.
[[nodiscard]] inline std::span<const Cue> cues_of(const Museum& museum, std::uint32_t picture,
                                                  std::uint32_t language) noexcept {
  const auto all = std::ranges::equal_range(museum.cues, picture, {}, &Cue::picture);
  if (all.empty()) return {};
  auto in_it = std::ranges::equal_range(all, language, {}, &Cue::language);
  if (in_it.empty())
    in_it = std::ranges::equal_range(all, all.front().language, {}, &Cue::language);
  return {in_it.begin(), in_it.end()};
}

/// What one may listen to at an exhibit, in that order.
[[nodiscard]] inline std::span<const ExhibitSound> sounds_of(const Museum& museum,
                                                             std::uint32_t exhibit) noexcept {
  const auto of_it = std::ranges::equal_range(museum.sounds, exhibit, {}, &ExhibitSound::exhibit);
  return {of_it.begin(), of_it.end()};
}

/// That sound as it is heard in a language: its recording in that language, else in the first of
/// the museum's in which there is one. One that is for everybody is in the first. Null where there
/// is none.
[[nodiscard]] inline const SpeechSound* recording_of(const Museum& museum, std::uint32_t sound,
                                                     std::uint32_t language) noexcept {
  const RecordingKey key(sound);
  const SpeechSound* found = find_sound(museum.speech, language, key.text());
  for (std::uint32_t other = 0; found == nullptr && other < museum.languages.size(); ++other)
    found = find_sound(museum.speech, other, key.text());
  return found;
}

/// What is read while that sound plays, in a language: its own, else the first of the museum's in
/// which there is any.
[[nodiscard]] inline std::span<const SoundCue> cues_of_sound(const Museum& museum,
                                                             std::uint32_t sound,
                                                             std::uint32_t language) noexcept {
  const auto all = std::ranges::equal_range(museum.sound_cues, sound, {}, &SoundCue::sound);
  if (all.empty()) return {};
  auto in_it = std::ranges::equal_range(all, language, {}, &SoundCue::language);
  if (in_it.empty())
    in_it = std::ranges::equal_range(all, all.front().language, {}, &SoundCue::language);
  return {in_it.begin(), in_it.end()};
}

/// Makes the kiosk the one with that id; false, and nothing changed, where there is none. Strollers
/// stay away from a floor that their entrances are not on.
[[nodiscard]] inline bool stand_at(Museum& museum, std::string_view id) {
  const auto kiosk = std::ranges::find(museum.kiosks, id, &KioskPlace::id);
  if (kiosk == museum.kiosks.end()) return false;
  if (kiosk->floor != museum.kiosk_floor) museum.ambient = {};
  museum.kiosk_floor = kiosk->floor;
  museum.kiosk = kiosk->placement;
  return true;
}

}  // namespace docent
