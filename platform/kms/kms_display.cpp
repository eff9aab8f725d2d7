#include "platform/kms/kms_display.h"

#include <EGL/egl.h>
// eglext.h needs egl.h before it
#include <EGL/eglext.h>
#include <drm.h>
#include <fmt/format.h>
#include <poll.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "platform/egl/context.h"
#include "platform/journal/journal.h"
#include "platform/kms/console.h"
#include "platform/kms/dumb_buffer.h"
#include "platform/kms/graphics_card.h"
#include "platform/kms/hotplug.h"
#include "platform/kms/scanout.h"
#include "platform/kms/swapchain.h"

namespace docent::kms {
namespace {

using journal::Message;

using namespace std::chrono_literals;
using std::chrono::nanoseconds;
using AtomicRequest = std::unique_ptr<drmModeAtomicReq, CloseWith<drmModeAtomicFree>>;

/// While nothing can be shown, the frame loop still hears signals and moves its clock this often.
constexpr nanoseconds longest_wait = 90ms;
/// Without a screen there is something to draw on all the same, so that the guide has a shape.
constexpr PixelSize size_without_screen{1920, 1080};

nanoseconds now() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch();
}

/// A mode as the kernel keeps it; it goes with this.
class ModeBlob {
 public:
  ModeBlob(int fd, const drmModeModeInfo& mode) noexcept : fd_(fd) {
    if (drmModeCreatePropertyBlob(fd, &mode, sizeof mode, &id_) != 0) id_ = 0;
  }
  ModeBlob(ModeBlob&& other) noexcept : fd_(other.fd_), id_(std::exchange(other.id_, 0)) {}
  ModeBlob& operator=(ModeBlob&& other) noexcept {
    std::swap(fd_, other.fd_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~ModeBlob() {
    if (id_ != 0) drmModeDestroyPropertyBlob(fd_, id_);
  }
  std::uint32_t id() const noexcept { return id_; }

 private:
  int fd_;
  std::uint32_t id_ = 0;
};

/// The screens that are driven at the moment.
struct Outputs {
  std::vector<Pipe> pipes;
  std::vector<ModeBlob> modes;  ///< By pipe.
  Rotation panel = Rotation::None;
  std::optional<double> diagonal_inches;
  nanoseconds period = 16'666'667ns;
};

class Kms final : public KmsDisplay {
 public:
  Kms(GraphicsCard card, const WantedOutput& wanted) : card_(std::move(card)), wanted_(wanted) {}
  Kms(const Kms&) = delete;
  Kms& operator=(const Kms&) = delete;

  ~Kms() override {
    const nanoseconds until = now() + longest_flip;
    while (scanout_.is_flipping && now() < until) wait_for_events(until);
  }

  Result<void> open(const FindPoster& find_poster) {
    request_.reset(drmModeAtomicAlloc());
    if (!request_) return failed("out of memory");
    if (auto console = QuietConsole::take()) console_.emplace(std::move(*console));
    if (find_poster) show_poster(find_poster);
    gbm_.reset(gbm_create_device(fd()));
    if (!gbm_) return failed("GBM cannot use it");
    auto display = egl::open_egl(EGL_PLATFORM_GBM_KHR, gbm_.get());
    if (!display) return std::unexpected(display.error());
    egl_ = std::move(*display);
    const auto config =
        egl::choose_config(egl_.get(), {EGL_WINDOW_BIT, static_cast<EGLint>(scanout_format)});
    if (!config) return std::unexpected(config.error());
    config_ = *config;
    auto context = egl::make_context(egl_.get(), config_);
    if (!context) return std::unexpected(context.error());
    context_ = std::move(*context);
    await_poster();
    look_again();
    if (chain_.gbm) return {};
    return use_size(wanted_.size == PixelSize{} ? size_without_screen : wanted_.size);
  }

  DisplayState wait_for_page_flip() noexcept override {
    const nanoseconds until = now() + longest_wait;
    // Nothing was committed: the next frame is due at the next vertical blank all the same.
    const nanoseconds due = was_presented_ ? nanoseconds{0} : next_blank();
    was_presented_ = false;
    for (;;) {
      const nanoseconds time = now();
      const ScanoutStep step = next_step(scanout_, time);
      can_show_ = step == ScanoutStep::Draw;
      const nanoseconds end = can_show_ ? std::min(until, due) : until;
      if (state_ != DisplayState::Open || time >= end) return state_;
      take(step, end);
    }
  }

  bool can_show() const noexcept override { return can_show_; }
  bool wants_frame() const noexcept override { return lacks_frame_ || !scanout_.is_mode_set; }
  bool has_shown() const noexcept override { return !lacks_frame_; }
  void light(bool is_wanted) noexcept override { want_screen(scanout_, is_wanted); }
  std::optional<double> diagonal_inches() const noexcept override {
    return outputs_.diagonal_inches;
  }

  RenderTarget target() const noexcept override {
    return {0, chain_.size, Encoding::Plain, outputs_.panel};
  }

  std::uint32_t age() const noexcept override { return egl::age_of(egl_.get(), chain_.egl.get()); }

  void present() noexcept override {
    if (!eglSwapBuffers(egl_.get(), chain_.egl.get())) {
      state_ = DisplayState::Lost;
      return;
    }
    gbm_bo* next = gbm_surface_lock_front_buffer(chain_.gbm.get());
    if (next == nullptr) return;
    const CommitResult result = commit(chain_.size, framebuffer_of(fd(), next));
    committed(scanout_, result, now());
    was_presented_ = result == CommitResult::Taken;
    lacks_frame_ = !was_presented_;
    if (was_presented_)
      chain_.flipping = next;
    else
      gbm_surface_release_buffer(chain_.gbm.get(), next);
    if (result == CommitResult::NoMaster)
      tell(Message::CardTaken, "another program has taken the graphics card");
  }

  std::string description() const override {
    if (outputs_.pipes.empty()) return fmt::format("{}, without a screen for now", card_.path);
    std::vector<std::string> screens;
    for (const Pipe& pipe : outputs_.pipes)
      screens.push_back(fmt::format("{}, {} x {} pixels at {} Hz", pipe.connector_name,
                                    pipe.mode.hdisplay, pipe.mode.vdisplay, pipe.mode.vrefresh));
    return fmt::format("{} of {}", fmt::join(screens, " and "), card_.path);
  }
  std::string_view loss() const noexcept override { return loss_; }
  void abandon() noexcept override {
    if (console_) console_->give_back();
  }

 private:
  int fd() const noexcept { return card_.fd.get(); }

  std::unexpected<Error> failed(std::string_view why) const {
    return std::unexpected(Error{Errc::Environment, fmt::format("{}: {}", card_.path, why)});
  }

  /// For the journal; never in an ordinary frame.
  void tell(journal::Message message, std::string_view what) const noexcept {
    journal::tell(message, fmt::format("{} ({})", what, card_.path));
  }

  /// Once until a frame is shown again.
  void tell_frame_lost(std::string_view what) noexcept {
    if (!std::exchange(lost_frames_, true)) tell(Message::FrameLost, what);
  }

  /// When the next vertical blank will be, by those before it.
  nanoseconds next_blank() noexcept {
    const nanoseconds time = now(), period = outputs_.period;
    last_blank_ += (time - last_blank_) / period * period;
    return last_blank_ + period;
  }

  void take(ScanoutStep step, nanoseconds end) noexcept {
    switch (step) {
      case ScanoutStep::Draw:
        return wait_for_events(end);
      case ScanoutStep::AwaitFlip:
      case ScanoutStep::Rest:
        return wait_for_events(std::min(end, resume_at(scanout_, now())));
      case ScanoutStep::GiveUpFlip:
        gave_up_flip(scanout_);
        lacks_frame_ = true;
        tell_frame_lost("the screen did not show a frame within a second; its mode is set anew");
        return show_flipped();
      case ScanoutStep::LookAgain:
        return look_again();
      case ScanoutStep::TakeCard:
        return take_card();
      case ScanoutStep::TurnOff:
        return turn_off();
    }
  }

  // What is shown before anything is drawn.

  void show_poster(const FindPoster& find_poster) {
    const CardReading reading = read_card(fd(), Probe::No);  // who opened the card has just probed
    const std::vector<OutputPlan> plans = output_plans(reading.state, wanted_);
    if (plans.empty()) return;
    const PixelSize size = plans[0].picture;
    const bool is_scaled = std::ranges::any_of(plans[0].routes, [&](const Route& route) {
      return route.place != PixelRect{0, 0, size.width, size.height};
    });
    const std::optional<Pixels> picture = is_scaled ? std::nullopt : find_poster(size);
    if (!picture) return;
    auto buffer = DumbBuffer::holding(fd(), *picture);
    if (!buffer) return;
    poster_.emplace(std::move(*buffer));
    outputs_ = outputs_of(reading, plans[0]);
    if (outputs_.pipes.empty()) return;
    turn_off_others(reading);
    const CommitResult result = commit(size, poster_->framebuffer());
    committed(scanout_, result, now());
    if (result != CommitResult::Taken) poster_.reset();
  }

  /// What is started takes longer than a flip is waited for.
  void await_poster() noexcept {
    const nanoseconds until = now() + longest_flip;
    while (scanout_.is_flipping && now() < until) wait_for_events(until);
    if (scanout_.is_flipping) gave_up_flip(scanout_);
  }

  // What the card, the kernel and the console tell.

  void wait_for_events(nanoseconds until) noexcept {
    std::array<pollfd, 3> sources{{{fd(), POLLIN, 0},
                                   {hotplug_.fd(), POLLIN, 0},
                                   {console_ ? console_->fd() : -1, POLLIN, 0}}};
    const nanoseconds wait = std::max(0ns, until - now());
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wait);
    const timespec patience{.tv_sec = seconds.count(), .tv_nsec = (wait - seconds).count()};
    if (ppoll(sources.data(), sources.size(), &patience, nullptr) <= 0) return;
    if ((sources[0].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) state_ = DisplayState::Lost;
    if ((sources[0].revents & POLLIN) != 0) read_flips();
    if (sources[1].revents != 0 && hotplug_.take()) heard_hotplug(scanout_);
    if (sources[2].revents != 0) hear_console();
  }

  /// A frame is shown when every screen has flipped to it. Flips that were given up come late, and
  /// count for nothing.
  void read_flips() noexcept {
    std::array<char, 1024> events;
    const ssize_t size = read(fd(), events.data(), events.size());
    for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof(drm_event)) <= size;) {
      drm_event head{};
      std::memcpy(&head, events.data() + at, sizeof head);
      if (head.type == DRM_EVENT_FLIP_COMPLETE) {
        drm_event_vblank flip{};
        std::memcpy(&flip, events.data() + at, sizeof flip);
        if (scanout_.is_flipping && flip.user_data == flip_number_ && --flips_missing_ == 0) {
          show_flipped();
          if (std::exchange(lost_frames_, false))
            tell(Message::FramesBack, "frames reach the screen again");
        }
      }
      if (head.length < sizeof head) return;
      at += head.length;
    }
  }

  void show_flipped() noexcept {
    flipped(scanout_);
    chain_.flipped();
    last_blank_ = now();
    retired_.reset();
    if (chain_.shown != nullptr) poster_.reset();
  }

  void hear_console() noexcept {
    for (;;) switch (console_->take_event()) {
        case ConsoleEvent::None:
          return;
        case ConsoleEvent::Leave:
          leave_card();
          console_->allow_leave();
          break;
        case ConsoleEvent::Return:
          console_->confirm_return();
          returned_to_console(scanout_, now());
          break;
      }
  }

  /// The next program finds the card at rest.
  void leave_card() noexcept {
    const nanoseconds until = now() + 100ms;
    while (scanout_.is_flipping && now() < until) {
      pollfd card{fd(), POLLIN, 0};
      if (poll(&card, 1, 20) > 0) read_flips();
    }
    chain_.flipped();
    left_console(scanout_);
    drmDropMaster(fd());
    tell(Message::CardTaken, "the console shows another terminal");
  }

  void take_card() noexcept {
    const bool is_granted = drmSetMaster(fd()) == 0;
    asked_for_card(scanout_, is_granted, now());
    if (is_granted) tell(Message::CardBack, "the graphics card is the guide's again");
    if (is_granted || waits_for_card_) {
      waits_for_card_ = !is_granted;
      return;
    }
    waits_for_card_ = true;
    tell(Message::CardTaken,
         "another program draws on the graphics card; the guide goes on when that has ended");
  }

  // Which screens there are.

  void look_again() noexcept {
    const bool had_screen = !outputs_.pipes.empty();
    const CardReading reading = read_card(fd(), Probe::Yes);
    const std::vector<OutputPlan> plans = output_plans(reading.state, wanted_);
    const bool has_screen =
        std::ranges::any_of(plans, [&](const OutputPlan& plan) { return use_plan(reading, plan); });
    if (!has_screen) {
      outputs_.pipes.clear();
      outputs_.modes.clear();
    }
    looked(scanout_, has_screen, now());
    if (!has_screen && has_other_card(card_, wanted_)) {
      state_ = DisplayState::Lost;
      loss_ = "the screen is at another graphics card now, where the guide begins anew";
    }
    if (has_screen == had_screen && was_told_) return;
    was_told_ = true;
    if (has_screen)
      tell(Message::ScreenTaken, fmt::format("draws on {}", description()));
    else
      tell(Message::NoScreen, why_none(reading.state, wanted_));
  }

  /// Empty pipes where the driver lacks something.
  Outputs outputs_of(const CardReading& reading, const OutputPlan& plan) const {
    Outputs outputs;
    outputs.pipes = pipes_of(fd(), reading, plan);
    if (outputs.pipes.empty()) return outputs;
    for (const Pipe& pipe : outputs.pipes) outputs.modes.emplace_back(fd(), pipe.mode);
    const Route& first = plan.routes[0];
    const Connector& connector = reading.state.connectors[first.connector];
    const Mode& mode = connector.modes[first.mode];
    outputs.panel = connector.panel;
    outputs.diagonal_inches =
        kms::diagonal_inches(connector.width_mm, connector.height_mm, mode.size);
    if (mode.refresh_mhz > 0) outputs.period = nanoseconds(1'000'000'000'000 / mode.refresh_mhz);
    return outputs;
  }

  bool use_plan(const CardReading& reading, const OutputPlan& plan) {
    Outputs next = outputs_of(reading, plan);
    if (next.pipes.empty()) return false;
    if (next.pipes.size() > 1 && !is_possible(next, plan.picture)) return false;
    if (chain_.size != plan.picture || !chain_.gbm)
      if (const auto sized = use_size(plan.picture); !sized) {
        tell(Message::NoScreen, sized.error().what);
        return false;
      }
    std::swap(outputs_, next);
    turn_off_others(reading);
    return true;
  }

  /// Makes buffers of another size; the context stays. The old ones go when the first new one is
  /// shown.
  Result<void> use_size(PixelSize size) {
    auto chain = make_swapchain(gbm_.get(), egl_.get(), config_, size);
    if (!chain) return std::unexpected(chain.error());
    const auto current = egl::make_current(egl_.get(), chain->egl.get(), context_.get());
    if (!current) return current;
    std::swap(chain_, *chain);
    if (chain->shown != nullptr) retired_.emplace(std::move(*chain));
    return {};
  }

  /// Would the driver take a picture of this size on these screens?
  bool is_possible(const Outputs& outputs, PixelSize picture) {
    const GbmBuffer buffer(gbm_bo_create(gbm_.get(), picture.width, picture.height, scanout_format,
                                         GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING));
    if (!buffer) return false;
    drmModeAtomicSetCursor(request_.get(), 0);
    add_modes(outputs);
    add_picture(outputs, picture, framebuffer_of(fd(), buffer.get()));
    return apply(DRM_MODE_ATOMIC_TEST_ONLY | DRM_MODE_ATOMIC_ALLOW_MODESET) == CommitResult::Taken;
  }

  void turn_off_others(const CardReading& reading) {
    const auto writes = writes_turning_off_others(fd(), reading, outputs_.pipes);
    if (writes.empty()) return;
    drmModeAtomicSetCursor(request_.get(), 0);
    for (const PropertyWrite& write : writes) add(write.object, write.property, write.value);
    apply(DRM_MODE_ATOMIC_ALLOW_MODESET);  // where it fails, the next mode setting says so
  }

  void turn_off() noexcept {
    drmModeAtomicSetCursor(request_.get(), 0);
    for (const Pipe& pipe : outputs_.pipes) add(pipe.crtc, pipe.crtc_active, 0);
    turned_off(scanout_, apply(DRM_MODE_ATOMIC_ALLOW_MODESET), now());
  }

  // Commits.

  void add(std::uint32_t object, std::uint32_t property, std::uint64_t value) noexcept {
    drmModeAtomicAddProperty(request_.get(), object, property, value);
  }

  void add_modes(const Outputs& outputs) noexcept {
    for (std::size_t i = 0; i < outputs.pipes.size(); ++i) {
      const Pipe& pipe = outputs.pipes[i];
      add(pipe.connector, pipe.connector_crtc, pipe.crtc);
      add(pipe.crtc, pipe.crtc_mode, outputs.modes[i].id());
      add(pipe.crtc, pipe.crtc_active, 1);
    }
  }

  void add_picture(const Outputs& outputs, PixelSize size, std::uint32_t framebuffer) noexcept {
    constexpr unsigned fixed_point = 16;  // source rectangles are in 16.16
    for (const Pipe& pipe : outputs.pipes) {
      const PlaneProperties& p = pipe.on_plane;
      add(pipe.plane, p.fb, framebuffer);
      add(pipe.plane, p.crtc, pipe.crtc);
      add(pipe.plane, p.src_x, 0);
      add(pipe.plane, p.src_y, 0);
      add(pipe.plane, p.src_w, std::uint64_t{size.width} << fixed_point);
      add(pipe.plane, p.src_h, std::uint64_t{size.height} << fixed_point);
      add(pipe.plane, p.crtc_x, pipe.place.x);
      add(pipe.plane, p.crtc_y, pipe.place.y);
      add(pipe.plane, p.crtc_w, pipe.place.width);
      add(pipe.plane, p.crtc_h, pipe.place.height);
    }
  }

  CommitResult apply(std::uint32_t flags, std::uintptr_t number = 0) noexcept {
    const int status =
        drmModeAtomicCommit(fd(), request_.get(), flags, std::bit_cast<void*>(number));
    return result_of(status < 0 ? -status : status);
  }

  CommitResult commit(PixelSize size, std::uint32_t framebuffer) noexcept {
    drmModeAtomicSetCursor(request_.get(), 0);
    std::uint32_t flags = DRM_MODE_PAGE_FLIP_EVENT;
    const CommitKind kind = commit_kind(scanout_, now());
    if (kind != CommitKind::SetModePatient) flags |= DRM_MODE_ATOMIC_NONBLOCK;
    if (kind == CommitKind::SetModePatient)
      tell_frame_lost("the graphics card has taken no frame for a second; its mode is set anew");
    if (kind != CommitKind::Flip) {
      add_modes(outputs_);
      flags |= DRM_MODE_ATOMIC_ALLOW_MODESET;
    }
    add_picture(outputs_, size, framebuffer);
    flips_missing_ = outputs_.pipes.size();
    return apply(flags, ++flip_number_);
  }

  std::optional<QuietConsole> console_;
  GraphicsCard card_;
  WantedOutput wanted_;
  Hotplug hotplug_;
  Scanout scanout_;
  GbmDevice gbm_;
  egl::EglDisplay egl_;
  EGLConfig config_ = nullptr;
  egl::EglContext context_;
  std::optional<DumbBuffer> poster_;  ///< Until the first frame is shown.
  std::optional<Swapchain> retired_;  ///< Still shown until the first frame in the new one is.
  Swapchain chain_;
  Outputs outputs_;
  AtomicRequest request_;
  std::uintptr_t flip_number_ = 0;
  std::size_t flips_missing_ = 0;  ///< Screens that have not flipped to the last frame yet.
  nanoseconds last_blank_{0};
  bool was_presented_ = false;  ///< Since the last wait.
  bool can_show_ = false;
  bool lacks_frame_ = true;  ///< What was drawn last was not taken.
  bool was_told_ = false, waits_for_card_ = false;
  bool lost_frames_ = false;  ///< And none has been shown since.
  std::string_view loss_ =
      "the graphics card takes no more frames; see what the kernel says of it (journalctl -k)";
  DisplayState state_ = DisplayState::Open;
};

}  // namespace

Result<std::unique_ptr<KmsDisplay>> open_kms(const WantedOutput& wanted,
                                             const FindPoster& find_poster) {
  QuietConsole::expect_signals();
  auto card = open_graphics_card(wanted);
  if (!card) return std::unexpected(card.error());
  auto kms = std::make_unique<Kms>(std::move(*card), wanted);
  if (auto opened = kms->open(find_poster); !opened) return std::unexpected(opened.error());
  return kms;
}

bool is_kms_free() noexcept {
  return is_a_card_free();
}

}  // namespace docent::kms
