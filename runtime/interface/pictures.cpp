#include "runtime/interface/pictures.h"

#include <algorithm>
#include <span>

#include "runtime/model/moving_picture.h"

namespace docent::interface {

bool is_pictured(const Museum& museum, std::uint32_t exhibit) noexcept {
  return has_picture(museum, museum.exhibits[exhibit]) ||
         !further_pictures(museum, exhibit).empty();
}

std::size_t picture_count(const Museum& museum, std::uint32_t exhibit) noexcept {
  return 1 + further_pictures(museum, exhibit).size();
}

ShownPicture shown_picture(const Museum& museum, const InterfaceState& state,
                           std::uint32_t exhibit) noexcept {
  const Exhibit& of_it = museum.exhibits[exhibit];
  const std::span<const FurtherPicture> further = further_pictures(museum, exhibit);
  ShownPicture shown{
      .image = of_it.image, .count = 1 + further.size(), .description = &of_it.description};
  const std::size_t leafed = state.exhibit == exhibit ? state.picture.value_or(0) : 0;
  if (leafed == 0 || leafed > further.size()) return shown;
  const FurtherPicture& picture = further[leafed - 1];
  shown.image = picture.image;
  shown.further = static_cast<std::uint32_t>(&picture - museum.pictures.data());
  shown.number = leafed + 1;
  if (!picture.caption.empty()) shown.caption = &picture.caption;
  shown.description = &picture.description;
  return shown;
}

std::optional<std::uint32_t> shown_video(const Museum& museum,
                                         const InterfaceState& state) noexcept {
  if (state.screen != Screen::Arrived || (state.glass != Glass::Whole && !state.seat) ||
      !state.exhibit || *state.exhibit >= museum.exhibits.size() || reads_more(museum, state))
    return std::nullopt;
  const std::uint32_t image = shown_picture(museum, state, *state.exhibit).image;
  if (image >= museum.images.size() || !is_video(museum.images[image])) return std::nullopt;
  return image;
}

bool can_listen(const Museum& museum, const InterfaceState& state) noexcept {
  return state.can_sound && state.screen == Screen::Arrived && state.glass == Glass::Whole &&
         state.exhibit && *state.exhibit < museum.exhibits.size() && !reads_more(museum, state) &&
         !sounds_of(museum, *state.exhibit).empty();
}

std::optional<std::uint32_t> shown_sound(const Museum& museum,
                                         const InterfaceState& state) noexcept {
  if (!state.sound || !can_listen(museum, state)) return std::nullopt;
  const std::span<const ExhibitSound> all = sounds_of(museum, *state.exhibit);
  if (*state.sound >= all.size()) return std::nullopt;
  return static_cast<std::uint32_t>(&all[*state.sound] - museum.sounds.data());
}

bool reads_more(const Museum& museum, const InterfaceState& state) noexcept {
  return state.tells_more && state.exhibit && *state.exhibit < museum.exhibits.size() &&
         !museum.exhibits[*state.exhibit].more.empty();
}

}  // namespace docent::interface
