#include "runtime/kiosk/edges.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "runtime/kiosk/hid_command.h"

namespace docent::kiosk {
namespace {

constexpr PixelSize usual_size{1920, 1080};

bool has_desktop() noexcept {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return is_set("WAYLAND_DISPLAY") || is_set("DISPLAY");
}

Rotation sum(Rotation a, Rotation b) noexcept {
  return static_cast<Rotation>((static_cast<unsigned>(a) + static_cast<unsigned>(b)) % 4);
}

bool is_quarter(Rotation rotation) noexcept {
  return rotation == Rotation::Quarter || rotation == Rotation::ThreeQuarters;
}

PixelSize turned(PixelSize size, Rotation rotation) noexcept {
  return is_quarter(rotation) ? PixelSize{size.height, size.width} : size;
}

PixelSize size_of(const EdgeSettings& settings) noexcept {
  return settings.size.width > 0 ? settings.size : usual_size;
}

Result<void> open_headless_edge(const EdgeSettings& settings, Edges& edges) {
  // In memory nothing hangs turned: the picture is as the visitor would see it.
  auto display = headless::open_headless(turned(size_of(settings), settings.rotation));
  if (!display) return std::unexpected(display.error());
  edges.headless = display->get();
  edges.rotation = Rotation::None;
  edges.display = std::move(*display);
  return {};
}

Result<void> open_window_edge(const EdgeSettings& settings, Edges& edges) {
  auto display = x11::open_window(size_of(settings));
  if (!display) return std::unexpected(display.error());
  edges.window = display->get();
  edges.display = std::move(*display);
  return {};
}

Result<void> open_kms_edge(const EdgeSettings& settings, Edges& edges) {
  auto display = kms::open_kms({.connector = settings.output,
                                .mirror = settings.mirror,
                                .size = settings.size,
                                .refresh_hz = settings.refresh_hz},
                               settings.find_poster);
  if (!display) return std::unexpected(display.error());
  edges.display = std::move(*display);
  return {};
}

Result<void> open_what_fits(const EdgeSettings& settings, Edges& edges) {
  if (kms::is_kms_free()) return open_kms_edge(settings, edges);
  return has_desktop() ? open_window_edge(settings, edges) : open_headless_edge(settings, edges);
}

/// By config::DisplayKind.
constexpr std::array<Result<void> (*)(const EdgeSettings&, Edges&), config::display_kinds.size()>
    openers{open_what_fits, open_kms_edge, open_window_edge, open_headless_edge};

}  // namespace

EdgeSettings edge_settings(const Options& options, const config::KioskConfig& config) {
  EdgeSettings settings;
  settings.kind = options.display.value_or(config.display);
  settings.size = options.size.value_or(PixelSize{static_cast<std::uint32_t>(config.width),
                                                  static_cast<std::uint32_t>(config.height)});
  settings.rotation = options.rotation.value_or(static_cast<Rotation>(config.rotate / 90));
  settings.refresh_hz = options.size ? 0 : static_cast<std::uint32_t>(config.refresh);
  settings.output = config.output;
  settings.mirror = config.mirror;
  settings.hid = options.hid;
  settings.keypads = named_keypads(config);
  return settings;
}

Result<Edges> open_edges(const EdgeSettings& settings) {
  Edges edges;
  edges.rotation = settings.rotation;
  if (const Result<void> opened = openers[static_cast<std::size_t>(settings.kind)](settings, edges);
      !opened)
    return std::unexpected(opened.error());
  // A headless run repeats exactly: it hears of devices only where they were named.
  if (edges.headless != nullptr && settings.hid.empty()) return edges;
  // A window has mouse and keyboard; the kiosk's own glass is for the console.
  if (edges.window != nullptr && settings.hid.empty()) return edges;
  auto devices = hid::InputDevices::open(settings.hid, settings.keypads);
  if (!devices) return std::unexpected(devices.error());
  edges.devices = std::move(*devices);
  return edges;
}

RenderTarget target_of(const Edges& edges) noexcept {
  RenderTarget target = edges.display->target();
  target.rotation = sum(target.rotation, edges.rotation);
  target.size = turned(target.size, target.rotation);
  target.shift_x = edges.shift.x;
  target.shift_y = edges.shift.y;
  return target;
}

input::Contact turned(input::Contact contact, Rotation rotation) noexcept {
  const float x = contact.x, y = contact.y;
  switch (rotation) {
    case Rotation::Quarter:
      return {contact.id, 1 - y, x};
    case Rotation::Half:
      return {contact.id, 1 - x, 1 - y};
    case Rotation::ThreeQuarters:
      return {contact.id, y, 1 - x};
    case Rotation::None:
      break;
  }
  return contact;
}

input::Contact shifted_back(input::Contact contact, const RenderTarget& target) noexcept {
  const auto share = [](std::int32_t pixels, std::uint32_t side) {
    return side == 0 ? 0 : static_cast<float>(pixels) / static_cast<float>(side);
  };
  contact.x = std::clamp(contact.x - share(target.shift_x, target.size.width), 0.0F, 1.0F);
  contact.y = std::clamp(contact.y - share(target.shift_y, target.size.height), 0.0F, 1.0F);
  return contact;
}

std::size_t arrived(Edges& edges, std::span<input::InputEvent> out) noexcept {
  std::size_t count = 0;
  if (edges.window != nullptr) count += edges.window->arrived(out);
  if (edges.devices) count += edges.devices->arrived(out.subspan(count));
  const RenderTarget target = target_of(edges);
  for (input::InputEvent& event : out.first(count))
    event.contact = shifted_back(turned(event.contact, target.rotation), target);
  return count;
}

}  // namespace docent::kiosk
