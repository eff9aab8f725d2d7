#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/guide/session.h"

namespace docent::guide {

/// Whose videos play where several visitors share a glass. A video takes a sixth of a processor and
/// 11 MB, so there are fewer players than seats.
///
/// A video that plays keeps its player. Who leafs to another while none is free finds it standing
/// still; who asks for it to be played gets the player of whichever has played longest. That one
/// stands still where it was, and goes on when its visitor asks.
class VideoTurns {
 public:
  static constexpr std::size_t most = 4;

  /// Once a step, after the sessions'. Stops the videos for which there is no player.
  void share(std::span<Session> sessions) noexcept;
  /// The session whose video a player shows; nothing while it is free.
  std::optional<std::size_t> watcher(std::size_t player) const noexcept {
    return players_[player].session;
  }

 private:
  struct Player {
    std::optional<std::size_t> session{};
    bool plays = false;
    std::uint64_t turn = 0;  ///< Grows with each video that begins to play, or goes on.
  };
  void free_players(std::span<const Session> sessions) noexcept;
  Player* player_of(std::size_t session) noexcept;
  Player* idle_player() noexcept;
  void rest(std::size_t session, float seconds) noexcept;
  void play(std::span<Session> sessions, std::size_t session, bool is_asked_for) noexcept;

  std::array<Player, most> players_{};
  std::uint64_t turns_ = 0;
};

}  // namespace docent::guide
