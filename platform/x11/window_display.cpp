#include "platform/x11/window_display.h"

#include <EGL/egl.h>
// eglext.h needs egl.h before it
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <poll.h>
#include <time.h>
#include <xcb/xcb.h>
#include <xcb/xcb_icccm.h>
#include <xcb/xcb_keysyms.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include "platform/clock/monotonic_clock.h"
#include "platform/egl/context.h"
#include "platform/handle.h"
#include "platform/x11/window_keys.h"

namespace docent::x11 {
namespace {

using Connection = std::unique_ptr<xcb_connection_t, CloseWith<xcb_disconnect>>;
using KeySymbols = std::unique_ptr<xcb_key_symbols_t, CloseWith<xcb_key_symbols_free>>;
template <typename T>
using Reply = std::unique_ptr<T, CloseWith<std::free>>;

constexpr std::chrono::nanoseconds frame_time{1'000'000'000 / 60};
constexpr std::uint8_t left_button = 1;

Error no_window(std::string_view why) {
  return {Errc::Environment,
          fmt::format("no window: {}; see that an X server runs and DISPLAY names it, or use "
                      "--display headless",
                      why)};
}

xcb_atom_t atom(xcb_connection_t* connection, std::string_view name) {
  const auto cookie =
      xcb_intern_atom(connection, 0, static_cast<std::uint16_t>(name.size()), name.data());
  const Reply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(connection, cookie, nullptr));
  return reply ? reply->atom : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
}

class Window final : public WindowDisplay {
 public:
  Window(Connection connection, PixelSize size)
      : connection_(std::move(connection)),
        socket_(xcb_get_file_descriptor(connection_.get())),
        size_(size) {}

  Result<void> open(xcb_screen_t* screen) {
    auto display = egl::open_egl(EGL_PLATFORM_XCB_EXT, connection_.get());
    if (!display) return std::unexpected(display.error());
    egl_ = std::move(*display);
    const auto config =
        egl::choose_config(egl_.get(), {EGL_WINDOW_BIT, static_cast<EGLint>(screen->root_visual)});
    if (!config) return std::unexpected(config.error());
    make_window(screen);
    auto context = egl::make_context(egl_.get(), *config);
    if (!context) return std::unexpected(context.error());
    context_ = std::move(*context);
    auto surface = egl::make_window_surface(egl_.get(), *config, &window_);
    if (!surface) return std::unexpected(surface.error());
    surface_ = std::move(*surface);
    return egl::make_current(egl_.get(), surface_.get(), context_.get());
  }

  DisplayState wait_for_page_flip() noexcept override {
    read_events();
    if (state_ != DisplayState::Open) return state_;
    // A virtual X server swaps at once, so the frame keeps its own time.
    const auto now = clock::monotonic_now();
    if (now < next_frame_) {
      const auto wait = next_frame_ - now;
      const timespec pause{.tv_sec = 0, .tv_nsec = static_cast<long>(wait.count())};
      nanosleep(&pause, nullptr);
    }
    next_frame_ = std::max(next_frame_ + frame_time, clock::monotonic_now());
    return state_;
  }

  RenderTarget target() const noexcept override {
    return {0, size_, Encoding::Plain, Rotation::None};
  }
  bool wants_frame() const noexcept override { return is_exposed_; }
  std::uint32_t age() const noexcept override { return egl::age_of(egl_.get(), surface_.get()); }

  void present() noexcept override {
    is_exposed_ = false;
    if (is_lost() || !eglSwapBuffers(egl_.get(), surface_.get())) state_ = DisplayState::Lost;
  }

  std::string description() const override {
    return fmt::format("a window of {} x {} pixels", size_.width, size_.height);
  }
  std::string_view loss() const noexcept override {
    return "the X server has gone, and the window with it; start docent again when it is back";
  }
  bool is_lost() const noexcept override {
    pollfd socket{.fd = socket_, .events = POLLRDHUP, .revents = 0};
    return poll(&socket, 1, 0) > 0 && (socket.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
  }

  std::size_t arrived(std::span<input::InputEvent> out) noexcept override {
    const std::size_t count = std::min(out.size(), event_count_);
    std::copy_n(events_.begin(), count, out.begin());
    std::copy(events_.begin() + static_cast<std::ptrdiff_t>(count),
              events_.begin() + static_cast<std::ptrdiff_t>(event_count_), events_.begin());
    event_count_ -= count;
    return count;
  }

 private:
  void make_window(xcb_screen_t* screen) {
    xcb_connection_t* c = connection_.get();
    window_ = xcb_generate_id(c);
    const std::array<std::uint32_t, 2> values{
        screen->black_pixel, XCB_EVENT_MASK_STRUCTURE_NOTIFY | XCB_EVENT_MASK_EXPOSURE |
                                 XCB_EVENT_MASK_BUTTON_PRESS | XCB_EVENT_MASK_BUTTON_RELEASE |
                                 XCB_EVENT_MASK_BUTTON_MOTION | XCB_EVENT_MASK_KEY_PRESS |
                                 XCB_EVENT_MASK_KEY_RELEASE};
    xcb_create_window(c, XCB_COPY_FROM_PARENT, window_, screen->root, 0, 0,
                      static_cast<std::uint16_t>(size_.width),
                      static_cast<std::uint16_t>(size_.height), 0, XCB_WINDOW_CLASS_INPUT_OUTPUT,
                      screen->root_visual, XCB_CW_BACK_PIXEL | XCB_CW_EVENT_MASK, values.data());
    constexpr std::string_view title = "docent";
    xcb_icccm_set_wm_name(c, window_, XCB_ATOM_STRING, 8, title.size(), title.data());
    const xcb_atom_t protocols = atom(c, "WM_PROTOCOLS");
    delete_window_ = atom(c, "WM_DELETE_WINDOW");
    xcb_icccm_set_wm_protocols(c, window_, protocols, 1, &delete_window_);
    xcb_map_window(c, window_);
    keys_.reset(xcb_key_symbols_alloc(c));
    xcb_flush(c);
  }

  void read_events() noexcept {
    if (xcb_connection_has_error(connection_.get()) != 0) state_ = DisplayState::Lost;
    while (const Reply<xcb_generic_event_t> event{xcb_poll_for_event(connection_.get())})
      handle(*event);
  }

  void handle(const xcb_generic_event_t& event) noexcept {
    constexpr std::uint8_t from_another_client = 0x80;
    switch (event.response_type & ~from_another_client) {
      case XCB_BUTTON_PRESS:
      case XCB_BUTTON_RELEASE:
      case XCB_MOTION_NOTIFY:
        handle_mouse(event);
        break;
      case XCB_KEY_PRESS:
      case XCB_KEY_RELEASE:
        handle_key(reinterpret_cast<const xcb_key_press_event_t&>(event));
        break;
      case XCB_CONFIGURE_NOTIFY: {
        const auto& size = reinterpret_cast<const xcb_configure_notify_event_t&>(event);
        size_ = {std::max<std::uint32_t>(size.width, 1), std::max<std::uint32_t>(size.height, 1)};
        break;
      }
      case XCB_EXPOSE:
        is_exposed_ = true;
        break;
      case XCB_CLIENT_MESSAGE: {
        const auto& message = reinterpret_cast<const xcb_client_message_event_t&>(event);
        if (message.data.data32[0] == delete_window_) state_ = DisplayState::Closed;
        break;
      }
      default:
        break;
    }
  }

  void handle_mouse(const xcb_generic_event_t& event) noexcept {
    // Press, release and motion have one layout.
    const auto& mouse = reinterpret_cast<const xcb_button_press_event_t&>(event);
    const std::uint8_t type = event.response_type & 0x7fU;
    const bool motion = type == XCB_MOTION_NOTIFY;
    if (!motion && mouse.detail != left_button) return;
    if (motion && (mouse.state & XCB_BUTTON_MASK_1) == 0) return;
    input::InputEvent finger;
    finger.kind = motion                     ? input::InputEvent::Kind::Move
                  : type == XCB_BUTTON_PRESS ? input::InputEvent::Kind::Down
                                             : input::InputEvent::Kind::Up;
    finger.contact = {1, share(mouse.event_x, size_.width), share(mouse.event_y, size_.height)};
    push(finger);
  }

  static float share(std::int16_t pixel, std::uint32_t side) noexcept {
    return std::clamp((static_cast<float>(pixel) + 0.5F) / static_cast<float>(side), 0.F, 1.F);
  }

  void handle_key(const xcb_key_press_event_t& event) noexcept {
    if (!keys_) return;
    const input::KeyName key =
        key_of_keysym(xcb_key_symbols_get_keysym(keys_.get(), event.detail, 0));
    if (key.key == input::Key::None) return;
    const bool down = (event.response_type & 0x7fU) == XCB_KEY_PRESS;
    push({.kind = down ? input::InputEvent::Kind::KeyDown : input::InputEvent::Kind::KeyUp,
          .contact = {},
          .key = key.key,
          .character = key.character});
  }

  void push(const input::InputEvent& event) noexcept {
    if (event_count_ < events_.size()) events_[event_count_++] = event;
  }

  Connection connection_;
  int socket_;  ///< Of the connection.
  KeySymbols keys_;
  xcb_window_t window_ = 0;
  xcb_atom_t delete_window_ = XCB_ATOM_NONE;
  PixelSize size_;
  DisplayState state_ = DisplayState::Open;
  bool is_exposed_ = true;  ///< What was drawn has been covered meanwhile.
  std::chrono::nanoseconds next_frame_{0};
  std::array<input::InputEvent, 256> events_{};
  std::size_t event_count_ = 0;
  egl::EglDisplay egl_;
  egl::EglContext context_;
  egl::EglSurface surface_;
};

}  // namespace

Result<std::unique_ptr<WindowDisplay>> open_window(PixelSize size) {
  int preferred = 0;
  Connection connection(xcb_connect(nullptr, &preferred));
  if (xcb_connection_has_error(connection.get()) != 0) {
    const char* name = std::getenv("DISPLAY");
    return std::unexpected(
        no_window(fmt::format("no X server answers at '{}'", name != nullptr ? name : "")));
  }
  auto screens = xcb_setup_roots_iterator(xcb_get_setup(connection.get()));
  for (; preferred > 0 && screens.rem > 1; --preferred) xcb_screen_next(&screens);
  if (screens.rem == 0) return std::unexpected(no_window("the X server has no screen"));
  constexpr std::uint32_t longest = 16384;
  if (size.width == 0 || size.height == 0 || size.width > longest || size.height > longest)
    return std::unexpected(no_window("each side may be 1 to 16384 pixels"));
  xcb_screen_t* screen = screens.data;
  auto window = std::make_unique<Window>(std::move(connection), size);
  if (auto opened = window->open(screen); !opened) return std::unexpected(opened.error());
  return window;
}

}  // namespace docent::x11
