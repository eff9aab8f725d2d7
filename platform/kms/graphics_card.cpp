#include "platform/kms/graphics_card.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

namespace docent::kms {
namespace {

using Resources = std::unique_ptr<drmModeRes, CloseWith<drmModeFreeResources>>;
using Connector = std::unique_ptr<drmModeConnector, CloseWith<drmModeFreeConnector>>;
using Encoder = std::unique_ptr<drmModeEncoder, CloseWith<drmModeFreeEncoder>>;
using PlaneList = std::unique_ptr<drmModePlaneRes, CloseWith<drmModeFreePlaneResources>>;
using Plane = std::unique_ptr<drmModePlane, CloseWith<drmModeFreePlane>>;
using ObjectProperties =
    std::unique_ptr<drmModeObjectProperties, CloseWith<drmModeFreeObjectProperties>>;
using Property = std::unique_ptr<drmModePropertyRes, CloseWith<drmModeFreeProperty>>;

struct PropertyValue {
  std::uint32_t id = 0;
  std::uint64_t value = 0;
};

std::optional<PropertyValue> find_property(int fd, std::uint32_t object, std::uint32_t type,
                                           std::string_view name) {
  const ObjectProperties all(drmModeObjectGetProperties(fd, object, type));
  if (!all) return std::nullopt;
  for (std::uint32_t i = 0; i < all->count_props; ++i) {
    const Property property(drmModeGetProperty(fd, all->props[i]));
    if (property && name == property->name)
      return PropertyValue{property->prop_id, all->prop_values[i]};
  }
  return std::nullopt;
}

bool find_properties(int fd, Pipe& pipe) {
  PipeProperties& p = pipe.properties;
  struct Wanted {
    std::uint32_t* id;
    std::uint32_t object, type;
    const char* name;
  };
  const std::array<Wanted, 13> wanted{{
      {&p.connector_crtc, pipe.connector, DRM_MODE_OBJECT_CONNECTOR, "CRTC_ID"},
      {&p.crtc_mode, pipe.crtc, DRM_MODE_OBJECT_CRTC, "MODE_ID"},
      {&p.crtc_active, pipe.crtc, DRM_MODE_OBJECT_CRTC, "ACTIVE"},
      {&p.plane_fb, pipe.plane, DRM_MODE_OBJECT_PLANE, "FB_ID"},
      {&p.plane_crtc, pipe.plane, DRM_MODE_OBJECT_PLANE, "CRTC_ID"},
      {&p.plane_src_x, pipe.plane, DRM_MODE_OBJECT_PLANE, "SRC_X"},
      {&p.plane_src_y, pipe.plane, DRM_MODE_OBJECT_PLANE, "SRC_Y"},
      {&p.plane_src_w, pipe.plane, DRM_MODE_OBJECT_PLANE, "SRC_W"},
      {&p.plane_src_h, pipe.plane, DRM_MODE_OBJECT_PLANE, "SRC_H"},
      {&p.plane_crtc_x, pipe.plane, DRM_MODE_OBJECT_PLANE, "CRTC_X"},
      {&p.plane_crtc_y, pipe.plane, DRM_MODE_OBJECT_PLANE, "CRTC_Y"},
      {&p.plane_crtc_w, pipe.plane, DRM_MODE_OBJECT_PLANE, "CRTC_W"},
      {&p.plane_crtc_h, pipe.plane, DRM_MODE_OBJECT_PLANE, "CRTC_H"},
  }};
  for (const Wanted& w : wanted) {
    const auto found = find_property(fd, w.object, w.type, w.name);
    if (!found) return false;
    *w.id = found->id;
  }
  return true;
}

/// Which CRTC, as a place in the card's list, can feed the connector.
std::optional<std::uint32_t> find_crtc(int fd, const drmModeRes& resources,
                                       const drmModeConnector& connector) {
  for (const std::uint32_t id :
       std::span(connector.encoders, static_cast<std::size_t>(connector.count_encoders))) {
    const Encoder encoder(drmModeGetEncoder(fd, id));
    if (!encoder) continue;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(resources.count_crtcs); ++i)
      if ((encoder->possible_crtcs & (1U << i)) != 0) return i;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> find_primary_plane(int fd, std::uint32_t crtc_place) {
  const PlaneList planes(drmModeGetPlaneResources(fd));
  if (!planes) return std::nullopt;
  for (const std::uint32_t id : std::span(planes->planes, planes->count_planes)) {
    const Plane plane(drmModeGetPlane(fd, id));
    if (!plane || (plane->possible_crtcs & (1U << crtc_place)) == 0) continue;
    const auto type = find_property(fd, id, DRM_MODE_OBJECT_PLANE, "type");
    if (type && type->value == DRM_PLANE_TYPE_PRIMARY) return id;
  }
  return std::nullopt;
}

/// How far a mode is from what is wanted; the preferred mode is nearest to nothing in particular.
std::uint64_t strangeness(const drmModeModeInfo& mode, PixelSize wanted) {
  if (wanted == PixelSize{}) return (mode.type & DRM_MODE_TYPE_PREFERRED) != 0 ? 0 : 1;
  const auto apart = [](std::uint32_t a, std::uint32_t b) { return a > b ? a - b : b - a; };
  return std::uint64_t{apart(mode.hdisplay, wanted.width)} + apart(mode.vdisplay, wanted.height);
}

std::optional<Pipe> find_pipe(int fd, PixelSize wanted) {
  const Resources resources(drmModeGetResources(fd));
  if (!resources) return std::nullopt;
  for (const std::uint32_t id :
       std::span(resources->connectors, static_cast<std::size_t>(resources->count_connectors))) {
    const Connector connector(drmModeGetConnector(fd, id));
    if (!connector || connector->connection != DRM_MODE_CONNECTED || connector->count_modes == 0)
      continue;
    const auto crtc = find_crtc(fd, *resources, *connector);
    if (!crtc) continue;
    const auto plane = find_primary_plane(fd, *crtc);
    if (!plane) continue;
    Pipe pipe;
    const char* kind = drmModeGetConnectorTypeName(connector->connector_type);
    pipe.connector_name =
        fmt::format("{}-{}", kind != nullptr ? kind : "screen", connector->connector_type_id);
    pipe.connector = id;
    pipe.crtc = resources->crtcs[*crtc];
    pipe.plane = *plane;
    pipe.mode = connector->modes[0];
    for (const drmModeModeInfo& mode :
         std::span(connector->modes, static_cast<std::size_t>(connector->count_modes)))
      if (strangeness(mode, wanted) < strangeness(pipe.mode, wanted)) pipe.mode = mode;
    if (find_properties(fd, pipe)) return pipe;
  }
  return std::nullopt;
}

Result<GraphicsCard> open_one(const std::string& path, PixelSize wanted) {
  const auto failed = [&](std::string_view why) {
    return std::unexpected(Error{Errc::Environment, fmt::format("{}: {}", path, why)});
  };
  GraphicsCard card{path, FileDescriptor(open(path.c_str(), O_RDWR | O_CLOEXEC)), {}};
  const int fd = card.fd.get();
  if (fd < 0)
    return failed(fmt::format("{}; the user must be in the group video", std::strerror(errno)));
  if (drmSetClientCap(fd, DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1) != 0 ||
      drmSetClientCap(fd, DRM_CLIENT_CAP_ATOMIC, 1) != 0)
    return failed("its driver has no atomic mode setting");
  if (drmSetMaster(fd) != 0)
    return failed(
        "another program draws on it; end that program (a desktop, say) or use "
        "--display window");
  auto pipe = find_pipe(fd, wanted);
  if (!pipe) return failed("no screen is connected to it");
  card.pipe = *pipe;
  return card;
}

}  // namespace

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)) {}
FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}
FileDescriptor::~FileDescriptor() {
  if (fd_ >= 0) close(fd_);
}

Result<GraphicsCard> open_graphics_card(PixelSize wanted) {
  constexpr int most_cards = 16;
  Error why{Errc::Environment,
            "there is no graphics card (/dev/dri/card*); use --display window or headless"};
  for (int i = 0; i < most_cards; ++i) {
    const std::string path = fmt::format("/dev/dri/card{}", i);
    if (access(path.c_str(), F_OK) != 0) continue;
    auto card = open_one(path, wanted);
    if (card) return card;
    why = card.error();
  }
  return std::unexpected(why);
}

}  // namespace docent::kms
