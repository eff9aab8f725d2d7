#include "runtime/kiosk/setup_screen.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "platform/clock/monotonic_clock.h"
#include "platform/pango/text_setter.h"
#include "runtime/kiosk/options.h"
#include "runtime/kiosk/signals.h"
#include "runtime/scene/theme.h"

namespace docent::kiosk {
namespace {

constexpr std::chrono::milliseconds between_frames{100};
constexpr int frames_between_looks = 5;
constexpr int frames_between_drawings = 10;  // nothing moves on it

struct Paragraph {
  std::string_view text;
  float size;  ///< Of its letters, as a share of the screen's shorter side.
  float gap;   ///< Above it, likewise.
  int weight = 400;
};

/// A word joiner behind a dash: an option is not torn from its dashes.
constexpr std::array paragraphs{
    Paragraph{"This kiosk has no museum to show yet", 0.058F, 0.0F, 600},
    Paragraph{"It is shown as soon as it is there. Bring it in one of these ways:", 0.034F, 0.03F},
    Paragraph{"Copy it.  On a desk: docent-content compile MUSEUM -o museum.db; then put it in the "
              "place that is named below.",
              0.034F, 0.045F},
    Paragraph{"Plug in a USB stick.  On a desk: docent-content release museum.db -o "
              "/media/STICK/docent -\u2060-\u2060key museum.key",
              0.034F, 0.03F},
    Paragraph{"Fetch it.  In /etc/docent/kiosk.toml: keys = [\"museum.pub\"] and source = "
              "\"https://...\"; then: systemctl enable -\u2060-\u2060now docent-update.timer",
              0.034F, 0.03F},
};
constexpr float reason_size = 0.026F, reason_gap = 0.06F, margin = 0.1F;

}  // namespace

SetupScreen::SetupScreen(const interface::SetText& set_text, PixelSize size, std::string_view why,
                         bool is_night) {
  const scene::Theme theme = scene::theme_of({}, false, is_night);
  const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
  const float side = std::min(width, height);
  list_.quads.push_back({.rect = {0, 0, 1, 1}, .colour = theme.paper});
  float y = margin * side;
  std::uint32_t texture = 0;
  const auto add = [&](const Paragraph& paragraph, scene::Colour colour) {
    y += paragraph.gap * side;
    const interface::TextStyle style{.weight = static_cast<std::uint16_t>(paragraph.weight),
                                     .size = paragraph.size * side,
                                     .max_lines = 6,
                                     .language = "en"};
    const interface::TextBitmap text =
        set_text(style, paragraph.text, static_cast<std::uint32_t>(width - 2 * margin * side));
    const auto id = static_cast<scene::TextureId>(++texture);
    holdings_.add_text(id, text.width, text.height, text.coverage);
    const auto text_width = static_cast<float>(text.width),
               text_height = static_cast<float>(text.height);
    list_.quads.push_back(
        {.rect = {margin * side / width, y / height, text_width / width, text_height / height},
         .fill = scene::QuadFill::Text,
         .colour = colour,
         .texture = id});
    y += text_height;
  };
  for (const Paragraph& paragraph : paragraphs) add(paragraph, theme.ink);
  add({why, reason_size, reason_gap}, theme.quiet_ink);
}

Result<std::unique_ptr<Exhibition>> wait_for_content(
    Edges& edges, gles::Renderer& renderer, ServiceNotice& notice,
    const std::filesystem::path& database, Error why, const std::function<bool()>& is_night,
    const std::function<Result<std::unique_ptr<Exhibition>>()>& load) {
  const Result<interface::SetText> set_text = pango::make_text_setter();
  if (!set_text) return std::unexpected(set_text.error());
  FileWatch watch(database);
  say(why, journal::Message::Refused);
  PixelSize size{};
  bool is_dark = false;
  std::unique_ptr<SetupScreen> screen;
  for (int frame = 0; !take_signal(SIGTERM) && !take_signal(SIGINT); ++frame) {
    const DisplayState state = edges.display->wait_for_page_flip();
    if (state == DisplayState::Closed) return nullptr;
    if (state == DisplayState::Lost)
      return std::unexpected(Error{Errc::Environment, std::string(edges.display->loss())});
    const RenderTarget target = target_of(edges);
    const bool is_new = !screen || target.size != size || is_dark != is_night();
    if (is_new) {
      size = target.size;
      is_dark = is_night();
      screen = std::make_unique<SetupScreen>(*set_text, size, why.what, is_dark);
    }
    const bool is_due = is_new || frame % frames_between_drawings == 0;
    if (edges.display->can_show() && (is_due || edges.display->wants_frame())) {
      screen->draw(renderer, target);
      edges.display->present();
    }
    notice.idle(clock::monotonic_now());
    std::this_thread::sleep_for(between_frames);
    if (frame % frames_between_looks != 0 && !is_signal_waiting(SIGHUP)) continue;
    // The first time in any case: it may have come since `why` was found out.
    if (frame > 0 && !watch.has_changed() && !take_signal(SIGHUP)) continue;
    Result<std::unique_ptr<Exhibition>> loaded = load();
    if (loaded) return loaded;
    if (loaded.error().what != why.what) say(loaded.error(), journal::Message::Refused);
    why = loaded.error();
    screen.reset();
  }
  return nullptr;
}

}  // namespace docent::kiosk
