#include "platform/alsa/jack_watch.h"

#include <alsa/asoundlib.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "platform/handle.h"
#include "runtime/model/last_catch.h"

namespace docent::alsa {

namespace {

using namespace std::chrono_literals;
constexpr auto between_looks = 100ms;  // how long a thread may overlook that it should stop
constexpr int looks_anew = 50;         // after so many: a card may have come

struct CloseControls {
  void operator()(snd_hctl_t* controls) const noexcept { snd_hctl_close(controls); }
};
using Controls = std::unique_ptr<snd_hctl_t, CloseControls>;

/// A card that has a socket which tells.
struct Card {
  Controls controls;
  std::vector<snd_hctl_elem_t*> sockets;
};

std::optional<Card> open_card(int number) {
  const std::string name = "hw:" + std::to_string(number);
  snd_hctl_t* raw = nullptr;
  if (snd_hctl_open(&raw, name.c_str(), SND_CTL_NONBLOCK) < 0) return std::nullopt;
  Card card{.controls = Controls(raw), .sockets = {}};
  if (snd_hctl_load(raw) < 0) return std::nullopt;
  for (auto* element = snd_hctl_first_elem(raw); element != nullptr;
       element = snd_hctl_elem_next(element))
    if (snd_hctl_elem_get_interface(element) == SND_CTL_ELEM_IFACE_CARD &&
        is_headphone_jack(snd_hctl_elem_get_name(element)))
      card.sockets.push_back(element);
  if (card.sockets.empty()) return std::nullopt;
  return card;
}

bool is_in(snd_hctl_elem_t* socket) {
  snd_ctl_elem_value_t* value = nullptr;
  if (snd_ctl_elem_value_malloc(&value) < 0) return false;
  const bool in =
      snd_hctl_elem_read(socket, value) >= 0 && snd_ctl_elem_value_get_boolean(value, 0);
  snd_ctl_elem_value_free(value);
  return in;
}

/// The cards that tell, looked for anew where one has gone and now and then.
class Cards {
 public:
  std::optional<bool> look(std::chrono::milliseconds time) {
    if (looks_-- <= 0) find();
    if (cards_.empty()) {
      std::this_thread::sleep_for(time);
      return std::nullopt;
    }
    if (!wait(time)) looks_ = 0;
    bool any = false;
    for (const Card& card : cards_)
      for (auto* socket : card.sockets) any = any || is_in(socket);
    return any;
  }

 private:
  void find() {
    looks_ = looks_anew;
    cards_.clear();
    for (int number = -1; snd_card_next(&number) >= 0 && number >= 0;)
      if (auto card = open_card(number)) cards_.push_back(std::move(*card));
  }

  /// Waits until a card says something; false where one has gone.
  bool wait(std::chrono::milliseconds time) {
    std::this_thread::sleep_for(time);
    return std::ranges::all_of(
        cards_, [](const Card& card) { return snd_hctl_handle_events(card.controls.get()) >= 0; });
  }

  std::vector<Card> cards_;
  int looks_ = 0;
};

}  // namespace

bool is_headphone_jack(std::string_view control) noexcept {
  return control.ends_with(" Jack") && !control.ends_with("Phantom Jack") &&
         (control.find("Headphone") != control.npos || control.find("Headset") != control.npos) &&
         control.find("Mic") == control.npos;
}

JackSource jacks_of_cards() {
  return [cards = std::make_shared<Cards>()](std::chrono::milliseconds time) {
    return cards->look(time);
  };
}

JackWatch::JackWatch(JackSource source)
    : thread_([this, source = std::move(source)](const std::stop_token& stop) {
        keep_running("watching for headphones", stop, [&] {
          while (!stop.stop_requested()) is_in_ = source(between_looks).value_or(false);
        });
      }) {}

std::optional<bool> JackWatch::changed() noexcept {
  const bool now = is_in_;
  if (now == std::exchange(told_, now)) return std::nullopt;
  return now;
}

}  // namespace docent::alsa
