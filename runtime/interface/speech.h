#pragma once

#include <array>
#include <vector>

#include "runtime/interface/control.h"
#include "runtime/interface/shown_way.h"
#include "runtime/interface/utterance.h"
#include "runtime/model/closures.h"

namespace docent::interface {

struct ViewRequest;

/// How loud speech may be set, and how fast: steps, of which one is usual.
inline constexpr std::size_t loudest = 10, usual_volume = 5;
inline constexpr std::array<float, 4> speech_speeds{0.75F, 1, 1.25F, 1.5F};
inline constexpr std::size_t usual_speed = 1;

/// Said when no more than `metres` of the way remain.
struct CountedUtterance {
  float metres = 0;
  Utterance said;
};

/// All that can be said while a view is shown, as a visitor needs who does not see it. Made on the
/// worker with the view; the frame thread picks.
struct Speech {
  Utterance opening;                        ///< What it is, and what it tells.
  Utterance help;                           ///< Where one is, what one can do, and by which keys.
  std::vector<Utterance> controls;          ///< One for each of the view: name, role and state.
  std::vector<CountedUtterance> remaining;  ///< Descending metres; of a way alone.
  std::array<Utterance, loudest + 1> volumes;
  std::array<Utterance, speech_speeds.size()> speeds;
  Utterance ended;  ///< From now on nothing is said.
  /// The visitor types or leafs: nothing is read on, and the focus stays.
  bool keeps_focus = false;
};

/// Something that can be said while a view is shown.
struct SpeechPart {
  enum class Kind : std::uint8_t {
    Nothing,
    Silence,
    Opening,
    Help,
    Control,
    Remaining,
    Volume,
    Speed,
    Ended
  };
  Kind kind = Kind::Nothing;
  std::size_t index = 0;  ///< Of those that there are several of.

  bool operator==(const SpeechPart&) const = default;
};
/// Null where nothing is said, or the view has no such part.
const Utterance* said_in(const Speech& speech, const SpeechPart& part) noexcept;

/// Pure. It is in the visitor's language; where that has no sounds, and another has, in the first
/// of the museum's that has. All pieces of it are among spoken_pieces(). `closed` and `way` as for
/// make_view.
Speech speech_of(const Museum& museum, const ViewRequest& request,
                 const std::vector<Control>& controls, const Closures& closed, const ShownWay* way);

}  // namespace docent::interface
