#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

/// What to do next with a screen, given what became of the last commit, the last flip, the session
/// and the cable: plain values and functions, without a graphics card.
namespace docent::kms {

/// What became of an atomic commit.
enum class CommitResult : std::uint8_t {
  Taken,     ///< A flip will follow.
  Busy,      ///< The one before it is still under way.
  NoMaster,  ///< The card is not ours, for now.
  Refused,   ///< Such a picture cannot be shown: the screen may have gone.
};
/// By errno of the commit; 0 for none.
CommitResult result_of(int error) noexcept;

/// How a frame is committed.
enum class CommitKind : std::uint8_t {
  Flip,            ///< The picture alone.
  SetMode,         ///< Mode and picture.
  SetModePatient,  ///< Waits in the kernel for what is under way there.
};

/// What has to be done before anything else.
enum class ScanoutStep : std::uint8_t {
  Draw,        ///< A frame may be drawn and committed.
  AwaitFlip,   ///< The last one is not shown yet.
  GiveUpFlip,  ///< It never will be.
  LookAgain,   ///< Read what is connected.
  TakeCard,    ///< Ask to be the card's master again.
  TurnOff,     ///< Take the picture and its signal away.
  Rest,        ///< Nothing, until the time of `resume_at`.
};

/// Times are of one clock that only moves forward.
struct Scanout {
  bool has_screen = false;
  bool is_master = true;
  bool is_here = true;    ///< False while the console shows another terminal.
  bool is_wanted = true;  ///< False while the screen is to be off.
  bool is_lit = false;    ///< A picture was committed since the screen was last turned off.
  bool is_mode_set = false;
  bool is_flipping = false;
  bool looks_again = true;  ///< What is connected may have changed.
  std::chrono::nanoseconds flip_begun{0};
  std::chrono::nanoseconds next_look{0}, next_try{0};       ///< Not before.
  std::optional<std::chrono::nanoseconds> refused_since{};  ///< Without a taken one between.
};

/// A flip that takes longer than this has been lost.
inline constexpr std::chrono::milliseconds longest_flip{1000};
/// How often it is looked for a screen that is not there, where the kernel does not tell.
inline constexpr std::chrono::milliseconds look_every{500};
/// How often the card is asked for after it was lost.
inline constexpr std::chrono::milliseconds ask_every{250};

ScanoutStep next_step(const Scanout& scanout, std::chrono::nanoseconds now) noexcept;
/// When there may be something to do again, should nothing happen meanwhile; at a Rest or an
/// AwaitFlip.
std::chrono::nanoseconds resume_at(const Scanout& scanout, std::chrono::nanoseconds now) noexcept;
/// How the next frame has to be committed.
CommitKind commit_kind(const Scanout& scanout, std::chrono::nanoseconds now) noexcept;

// What happened.

void committed(Scanout& scanout, CommitResult result, std::chrono::nanoseconds now) noexcept;
void flipped(Scanout& scanout) noexcept;
/// It was lost: the next frame sets the mode anew.
void gave_up_flip(Scanout& scanout) noexcept;
/// The kernel says that a screen came or went.
void heard_hotplug(Scanout& scanout) noexcept;
/// The connectors were read.
void looked(Scanout& scanout, bool has_screen, std::chrono::nanoseconds now) noexcept;
/// The card was asked for.
void asked_for_card(Scanout& scanout, bool is_granted, std::chrono::nanoseconds now) noexcept;
/// The console shows another terminal, whose programs have the card from now on.
void left_console(Scanout& scanout) noexcept;
void returned_to_console(Scanout& scanout, std::chrono::nanoseconds now) noexcept;
void want_screen(Scanout& scanout, bool is_wanted) noexcept;
void turned_off(Scanout& scanout, CommitResult result, std::chrono::nanoseconds now) noexcept;

}  // namespace docent::kms
