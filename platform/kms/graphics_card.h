#pragma once

#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "platform/display.h"
#include "platform/handle.h"
#include "runtime/model/result.h"

namespace docent::kms {

/// Owns a file descriptor.
class FileDescriptor {
 public:
  explicit FileDescriptor(int fd = -1) noexcept : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();
  int get() const noexcept { return fd_; }

 private:
  int fd_;
};

/// The identifiers of the properties that atomic mode setting writes (drm-kms, "Atomic Mode
/// Setting").
struct PipeProperties {
  std::uint32_t connector_crtc = 0;
  std::uint32_t crtc_mode = 0, crtc_active = 0;
  std::uint32_t plane_fb = 0, plane_crtc = 0;
  std::uint32_t plane_src_x = 0, plane_src_y = 0, plane_src_w = 0, plane_src_h = 0;
  std::uint32_t plane_crtc_x = 0, plane_crtc_y = 0, plane_crtc_w = 0, plane_crtc_h = 0;
};

/// How a picture gets to the glass: plane, CRTC, connector and its mode.
struct Pipe {
  std::string connector_name;  ///< As on the device: "HDMI-A-1".
  std::uint32_t connector = 0, crtc = 0, plane = 0;
  drmModeModeInfo mode{};
  PipeProperties properties;
};

/// A graphics card of which this program is the DRM master, and the pipe that the program drives.
struct GraphicsCard {
  std::string path;
  FileDescriptor fd;
  Pipe pipe;
};

/// Opens the first card that drives a connected screen and becomes its DRM master. The mode is the
/// preferred one, or that nearest to `wanted`, where that is not 0 by 0.
Result<GraphicsCard> open_graphics_card(PixelSize wanted);

}  // namespace docent::kms
