#include "runtime/guide/video_turns.h"

#include <algorithm>

namespace docent::guide {

void VideoTurns::free_players(std::span<const Session> sessions) noexcept {
  for (Player& player : players_)
    if (player.session && !sessions[*player.session].video()) player = {};
}

VideoTurns::Player* VideoTurns::player_of(std::size_t session) noexcept {
  const auto player = std::ranges::find(players_, std::optional(session), &Player::session);
  return player == players_.end() ? nullptr : &*player;
}

/// A free one, or else one whose video stands still.
VideoTurns::Player* VideoTurns::idle_player() noexcept {
  const auto idle = std::ranges::min_element(players_, {}, [](const Player& player) {
    if (player.plays) return 2;
    return player.session ? 1 : 0;
  });
  return idle->plays ? nullptr : &*idle;
}

/// Where the beginning is not in its texture yet, a free player puts it there.
void VideoTurns::rest(std::size_t session, float seconds) noexcept {
  Player* player = player_of(session);
  if (player == nullptr && seconds <= 0) player = idle_player();
  if (player == nullptr || (player->session && player->session != session)) return;
  player->session = session;
  player->plays = false;
}

void VideoTurns::play(std::span<Session> sessions, std::size_t session,
                      bool is_asked_for) noexcept {
  Player* player = player_of(session);
  if (player == nullptr) player = idle_player();
  if (player == nullptr && is_asked_for) {
    player = &*std::ranges::min_element(players_, {}, &Player::turn);
    sessions[*player->session].stop_video();
  }
  if (player == nullptr) return sessions[session].stop_video();
  if (player->session != session || !player->plays) *player = {session, true, ++turns_};
}

void VideoTurns::share(std::span<Session> sessions) noexcept {
  free_players(sessions);
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const std::optional<ShownVideo> video = sessions[i].video();
    if (!video) continue;
    if (video->plays)
      play(sessions, i, video->is_asked_for);
    else
      rest(i, video->seconds);
  }
}

}  // namespace docent::guide
