#pragma once

#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "platform/display.h"
#include "platform/file_descriptor.h"
#include "platform/handle.h"
#include "platform/kms/outputs.h"
#include "runtime/model/result.h"

namespace docent::kms {

/// A graphics card of which this program is the DRM master.
struct GraphicsCard {
  std::string path;
  FileDescriptor fd;
};

/// Opens the first card that drives a screen as wanted, or else the first that could, and becomes
/// its DRM master.
Result<GraphicsCard> open_graphics_card(const WantedOutput& wanted);
/// Is there a card with a connected screen that nobody else draws on?
bool is_a_card_free() noexcept;
/// Is there another card than this that drives a screen as wanted, and on which nobody else draws?
bool has_other_card(const GraphicsCard& card, const WantedOutput& wanted) noexcept;

/// What a card has, and how each part is told to it.
struct CardReading {
  CardState state;
  std::vector<std::vector<drmModeModeInfo>> modes;  ///< By connector and mode of `state`.
};
/// Reads what is connected; `Probe::Yes` asks the screens themselves, which may take a tenth of a
/// second each.
enum class Probe : std::uint8_t { No, Yes };
CardReading read_card(int fd, Probe probe);

/// The identifiers of the properties that every frame writes (drm-kms, "Atomic Mode Setting").
struct PlaneProperties {
  std::uint32_t fb = 0, crtc = 0;
  std::uint32_t src_x = 0, src_y = 0, src_w = 0, src_h = 0;
  std::uint32_t crtc_x = 0, crtc_y = 0, crtc_w = 0, crtc_h = 0;
};

/// How the picture gets to one screen: plane, CRTC, connector and its mode.
struct Pipe {
  std::string connector_name;
  std::uint32_t connector = 0, crtc = 0, plane = 0;
  drmModeModeInfo mode{};
  PixelRect place{};
  std::uint32_t connector_crtc = 0, crtc_mode = 0, crtc_active = 0;  ///< Properties.
  PlaneProperties on_plane{};
};

/// The pipes of a plan; empty where the driver lacks a property that is needed.
std::vector<Pipe> pipes_of(int fd, const CardReading& reading, const OutputPlan& plan);

/// One value that an atomic commit writes.
struct PropertyWrite {
  std::uint32_t object = 0, property = 0;
  std::uint64_t value = 0;
};
/// What takes the picture away from every screen that the pipes do not drive.
std::vector<PropertyWrite> writes_turning_off_others(int fd, const CardReading& reading,
                                                     const std::vector<Pipe>& pipes);

}  // namespace docent::kms
